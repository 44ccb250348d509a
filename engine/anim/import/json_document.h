#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Deepest nesting that is parsed: glTF itself needs about ten levels, extras rarely more.
inline constexpr int max_json_depth = 128;

/// Game play's marks on an animation, in its extras; each has a time in seconds and a name, in any order:
///     "extras": { "throng_data_keys": [ { "time": 0.31, "name": "footstep_left" } ] }
inline constexpr const char* data_keys_property = "throng_data_keys";

/// Parses a glTF document and leaves only what import uses: of extras the data keys, as a property of the animation; no
/// extension but those it reads, and every number that is an integer by value stored as one (glTF 2.0, 2.7 allows
/// "1.0"). Depth is checked on the text, before anything recursive sees it. Throws Refusal.
nlohmann::json parse_json(std::string_view text);

}  // namespace throng::import
