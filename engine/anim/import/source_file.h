#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace throng::import {

/// The contents of a .glb or .gltf file, as views into its bytes.
struct FileParts {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  ///< the BIN chunk of a .glb
};

/// Splits a file by its contents: a GLB container (glTF 2.0, chapter 4) or plain JSON. A file of another format is
/// refused by the name of that format, which its contents or the ending of `path` tell. Throws Refusal.
FileParts split_file(std::span<const std::byte> bytes, const std::filesystem::path& path);

/// The largest file that is read, in bytes.
inline constexpr std::size_t max_file_size = std::size_t{1} << 30U;

/// Returns all bytes of a model's file, or of a file that it names. Throws Refusal.
std::vector<std::byte> read_file(const std::filesystem::path& path);

}  // namespace throng::import
