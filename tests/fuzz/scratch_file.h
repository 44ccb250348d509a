#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tests/own_folder.h"

namespace throng::fuzz {

/// A file for readers that take a path, in a folder of its own. It holds the last input.
class ScratchFile {
 public:
  explicit ScratchFile(std::string_view name) : file_(folder_.path() / name) {}

  void put(std::span<const std::byte> bytes) const;
  void put(const std::uint8_t* data, std::size_t size) const { put(std::as_bytes(std::span(data, size))); }
  std::string path() const { return file_.string(); }

 private:
  test::OwnFolder folder_;
  std::filesystem::path file_;
};

}  // namespace throng::fuzz
