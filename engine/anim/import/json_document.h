#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Deepest nesting that is parsed: glTF itself needs about ten levels, extras rarely more.
inline constexpr int max_json_depth = 128;

/// Parses a glTF document and leaves only what import uses: no extras, no extension but those it reads, and
/// every number that is an integer by value stored as one (glTF 2.0, 2.7 allows "1.0"). Depth is checked on the text,
/// before anything recursive sees it. Throws Refusal.
nlohmann::json parse_json(std::string_view text);

}  // namespace throng::import
