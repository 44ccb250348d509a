#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"

namespace throng {

/// The bytes of a file, mapped into memory to be read. `owner` keeps them there.
struct MappedFile {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> owner;
};

/// A file that is open to be read. No other code of the project opens files to read them.
/// Errors are the ends of sentences that begin with the file's name: "it is a folder; name a .glb or .gltf".
class InputFile {
 public:
  /// Opens a file; follows links. `wanted` says what the file should be. It never waits.
  /// Errors: there is no such file, it is a folder, a pipe, a device or a socket, it may not be read, or a pointer of
  /// Git LFS stands in its place.
  static Result<InputFile> open(const std::filesystem::path& path, std::string_view wanted = "a file");

  /// Returns how many bytes it had when it was opened.
  std::uint64_t size() const { return size_; }
  /// Reads on from where the last call ended; returns how many bytes were read, fewer than asked for at the end alone.
  Result<std::size_t> read(std::span<std::byte> bytes);
  /// Goes on reading at this byte of the file.
  Status go_to(std::uint64_t byte);
  /// Maps all of the file. It must not be cut short while it is mapped: to replace it, rename another file to its
  /// name.
  Result<MappedFile> map() const;

 private:
  InputFile(std::shared_ptr<void> handle, std::uint64_t size) : handle_(std::move(handle)), size_(size) {}
  static Result<InputFile> unless_pointer(InputFile file);

  std::shared_ptr<void> handle_;  // the system's handle; closes the file
  std::uint64_t size_;
};

/// Returns all bytes of a file. Errors: those of InputFile, and it has more than `most` bytes.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path, std::string_view wanted, std::size_t most);

/// Reads a file as a text; otherwise as read_file().
Result<std::string> read_text(const std::filesystem::path& path, std::string_view wanted, std::size_t most);

/// Maps all of a file.
Result<MappedFile> map_file(const std::filesystem::path& path, std::string_view wanted);

}  // namespace throng
