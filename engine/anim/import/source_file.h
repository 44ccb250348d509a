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

/// Splits a file by its contents, not by its name: a GLB container (glTF 2.0, chapter 4) or plain JSON. Throws Refusal.
FileParts split_file(std::span<const std::byte> bytes);

/// The largest file that is read, in bytes.
inline constexpr std::size_t max_file_size = std::size_t{1} << 30U;

/// Returns all bytes of a regular file. Throws Refusal.
std::vector<std::byte> read_file(const std::filesystem::path& path);

/// Returns the path of a relative URI of a model in `folder`. Throws Refusal for a URI that could lead out of `folder`:
/// absolute paths, schemes, "..", links, bad escapes.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, std::string_view uri);

/// Returns the bytes of a base64 data URI (RFC 2397), or nothing for any other URI. Throws Refusal.
std::optional<std::vector<std::byte>> decode_data_uri(std::string_view uri);

}  // namespace throng::import
