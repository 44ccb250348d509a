#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/anim/import/model_files.h"

namespace throng::import {

/// The bytes of every buffer view. `storage` owns views that are not part of the file itself.
struct BufferViews {
  std::vector<std::vector<std::byte>> storage;
  std::vector<std::span<const std::byte>> views;
};

/// Finds the buffer views of a document that passed check_json. They lie in the BIN chunk, in data URIs and in `files`,
/// and are decompressed where EXT_meshopt_compression or KHR_meshopt_compression says so. A file that several buffers
/// name is read once. Charges `memory`. Throws Refusal.
BufferViews load_buffer_views(const nlohmann::json& document, std::optional<std::span<const std::byte>> binary_chunk,
                              ModelFiles& files, std::vector<std::string>& repairs, MemoryAccount& memory);

}  // namespace throng::import
