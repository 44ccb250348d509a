#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace throng::import {

/// The contents of a .glb or .gltf file, as views into its bytes.
struct FileParts {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;  ///< the BIN chunk of a .glb
};

/// Splits a file by its contents, not by its name: a GLB container (glTF 2.0, chapter 4) or plain JSON. Throws Refusal.
FileParts split_file(std::span<const std::byte> bytes);

}  // namespace throng::import
