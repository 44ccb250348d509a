#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// The deepest nesting that is parsed. glTF itself needs about ten levels, extras rarely more.
inline constexpr std::size_t max_json_depth = 128;

/// Data keys for game play, in an animation's extras. Each has a time in seconds and a name; they may have any order:
///     "extras": { "throng_data_keys": [ { "time": 0.31, "name": "footstep_left" } ] }
inline constexpr const char* data_keys_property = "throng_data_keys";

/// Numbers over time for game play, in an animation's extras, by name. Times are in seconds and ascend; each has a
/// value:
///     "extras": { "curves": { "glow": { "times": [ 0, 0.5, 1 ], "values": [ 0, 1, 0 ] } } }
inline constexpr const char* curves_property = "curves";

/// Coarser meshes, in the extras of a node that draws a skinned mesh: nodes whose meshes have the same skin, finest
/// first, and how far in metres their surface is from the full one. The nodes stand outside of the default scene, so
/// that other programs do not draw them too.
///     "extras": { "throng_mesh_lods": [ { "node": 63, "error": 0.01 } ] }
inline constexpr const char* mesh_lods_property = "throng_mesh_lods";

/// The extras of a node that draws a mesh may make it a part (anim::ModelPart); a text alone is the slot:
///     "extras": { "throng_part": { "slot": "top", "body": "woman", "covers": [ "torso" ], "tags": [ "warm" ] } }
inline constexpr const char* part_property = "throng_part";

/// Names of a mesh's morph targets, in its extras, where exporters write them.
inline constexpr const char* target_names_property = "targetNames";

/// Parses a glTF document and keeps only the parts that import uses. Of extras, it keeps data keys, curves, mesh LODs,
/// parts and names of morph targets as properties of the animation, the node and the mesh; of extensions, the
/// properties that import reads. Every number with an integer value becomes an integer (glTF 2.0, 2.7 allows "1.0"),
/// and every name plain text of at most 1,024 bytes. Parses no deeper than max_json_depth, so that its readers may be
/// recursive. `repairs` names all that was left out. Throws Refusal.
nlohmann::json parse_json(std::string_view text, std::vector<std::string>& repairs);

/// Checks that everything import reads has the type, the length and, for an index, the range that glTF demands, and
/// that no version newer than 2.0 is needed. Throws Refusal with the object's name.
void check_json(const nlohmann::json& document);

/// Returns an array of an object, or an empty one.
const nlohmann::json& array_of(const nlohmann::json& object, const char* key);

/// Returns a property of a value that may be anything, or null.
nlohmann::json* find_property(nlohmann::json& object, const char* key);

/// Returns the elements of an array property, or none.
std::span<nlohmann::json> elements(nlohmann::json& object, const char* key);

/// Returns a name as far as a line shows it.
std::string shown_name(const std::string& name);

/// Returns `node 3 "Hips"` for an object of the document, for messages.
std::string json_label(const std::string& type, std::size_t index, const nlohmann::json& object);

}  // namespace throng::import
