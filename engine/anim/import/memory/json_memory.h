#pragma once

#include <cstdint>
#include <string_view>

namespace throng::import {

/// Returns about how many bytes a JSON text takes as a tree of nlohmann::json: no fewer than it does.
std::uint64_t parsed_json_memory(std::string_view text);

}  // namespace throng::import
