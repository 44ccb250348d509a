#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace throng::fuzz {

/// A file for readers that take a path, in a folder of its own below the system's temporary one (TMPDIR). It holds the
/// last input. The folder is removed at the end.
class ScratchFile {
 public:
  explicit ScratchFile(std::string_view name);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  void put(std::span<const std::byte> bytes) const;
  void put(const std::uint8_t* data, std::size_t size) const { put(std::as_bytes(std::span(data, size))); }
  std::string path() const { return file_.string(); }

 private:
  std::filesystem::path file_;
};

}  // namespace throng::fuzz
