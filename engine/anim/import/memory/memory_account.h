#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace throng::import {

// An import may hold this much if its caller sets no limit.
inline constexpr std::uint64_t basic_memory = 64'000'000;  ///< bytes, however small the file is
inline constexpr std::uint64_t memory_a_file_byte = 4;     ///< for each byte of the file and of the files that it names

// Images and JSON are packed far more densely than all else. Their memory up to here does not count; a flat PNG of
// 4096 pixels squared takes 67 MB, and may have 15 KB.
inline constexpr std::uint64_t most_free_image_memory = 1'000'000'000;  ///< bytes of pixels, all images together
inline constexpr std::uint64_t most_decoder_memory = 1'000'000'000;     ///< bytes, of one image at a time
inline constexpr std::uint64_t most_decoded_memory = 4'000'000'000;     ///< bytes, all images before they are scaled
inline constexpr std::uint64_t free_memory_a_json_byte = 32;
inline constexpr std::uint64_t most_free_json_memory = 256'000'000;  ///< bytes

/// What lets an import hold more, as refusals name it.
inline constexpr const char* larger_limit = "a larger memory limit (--memory-limit, LoadOptions::memory_limit)";

/// Says that an import would hold more memory than it may. It is no Refusal, so that no caller mends the object and
/// goes on.
class MemoryRefusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Counts the bytes that one import holds. Code that takes memory on a file's word charges it here first.
class MemoryAccount {
 public:
  /// `limit` is in bytes. 0 stands for basic_memory and the files' share, and then images and JSON count as above.
  explicit MemoryAccount(std::uint64_t limit = 0);

  /// Counts the bytes of a file, which may allow more. Call it once a file, before it is read. Throws MemoryRefusal.
  void add_file(std::uint64_t size, const std::string& name);

  /// Counts bytes that `object` takes. Throws MemoryRefusal where there are not as many left.
  void charge(std::uint64_t bytes, const std::string& object);
  void release(std::uint64_t bytes) { held_ -= bytes; }

  /// Counts bytes that stay to the end, in any scope. Throws MemoryRefusal likewise.
  void charge_for_good(std::uint64_t bytes, const std::string& object);

  /// Returns how many bytes the pixels of an image may keep that is the first of `images`, so that each has its share.
  std::uint64_t image_share(std::uint64_t encoded, std::size_t images) const;
  /// Returns how many bytes the decoder of an image may hold for a while, the pixels among them.
  std::uint64_t decoder_memory() const;
  /// Counts decoded pixels, kept or not. Throws MemoryRefusal where earlier images had too many.
  void count_decoded(std::uint64_t bytes, const std::string& object);
  /// Counts the pixels of an image, which stay to the end. The rest of the images' allowance is taken first.
  /// Throws MemoryRefusal.
  void charge_for_image(std::uint64_t bytes, const std::string& object);

  /// Returns the bytes that JSON of so many bytes may take without being counted.
  std::uint64_t json_allowance(std::uint64_t text) const;

  std::uint64_t held() const { return held_; }  ///< without the bytes that were charged for good
  std::uint64_t left() const { return held_ + for_good_ < limit_ ? limit_ - held_ - for_good_ : 0; }

  /// Refuses an object that needs so many bytes, and may take `free` more than are left.
  [[noreturn]] void refuse(std::uint64_t bytes, const std::string& object, std::uint64_t free = 0) const;

 private:
  bool is_given_;
  std::uint64_t limit_;
  std::uint64_t held_ = 0, for_good_ = 0;
  std::uint64_t free_image_memory_;
  std::uint64_t decoded_ = 0;
};

/// Gives back the bytes that are charged while it lives, except kept bytes.
class MemoryScope {
 public:
  explicit MemoryScope(MemoryAccount& account) : account_(account), rest_(account.held()) {}
  MemoryScope(const MemoryScope&) = delete;
  MemoryScope& operator=(const MemoryScope&) = delete;
  ~MemoryScope() {
    if (account_.held() > rest_) account_.release(account_.held() - rest_);
  }

  /// Keeps so many of the bytes that were charged.
  void keep(std::uint64_t bytes) { rest_ += bytes; }

 private:
  MemoryAccount& account_;
  std::uint64_t rest_;  // bytes that stay held
};

}  // namespace throng::import
