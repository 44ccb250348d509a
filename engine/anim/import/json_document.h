#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Deepest nesting that is parsed: glTF itself needs about ten levels, extras rarely more.
inline constexpr int max_json_depth = 128;

/// Game play's marks on an animation, in its extras; each has a time in seconds and a name, in any order:
///     "extras": { "throng_data_keys": [ { "time": 0.31, "name": "footstep_left" } ] }
inline constexpr const char* data_keys_property = "throng_data_keys";

/// Extras of a node that draws a skinned mesh: nodes with coarser meshes of the same skin, finest first, and how far
/// in metres their surface is from the full one's. They stand outside of the default scene, so that nobody else draws
/// them too.
///     "extras": { "throng_mesh_lods": [ { "node": 63, "error": 0.01 } ] }
inline constexpr const char* mesh_lods_property = "throng_mesh_lods";

/// Parses a glTF document and leaves only what import uses: of extras the data keys and mesh LODs, as properties of the
/// animation and the node; no extension but those it reads, and every number that is an integer by value stored as one
/// (glTF 2.0, 2.7 allows "1.0"). Depth is checked on the text, before anything recursive sees it. Throws Refusal.
nlohmann::json parse_json(std::string_view text);

}  // namespace throng::import
