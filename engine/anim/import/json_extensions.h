#pragma once

#include <array>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace throng::import {

/// Extensions whose content import reads.
inline constexpr std::array read_extensions{"EXT_meshopt_compression",
                                            "EXT_texture_webp",
                                            "KHR_draco_mesh_compression",
                                            "KHR_materials_emissive_strength",
                                            "KHR_materials_pbrSpecularGlossiness",
                                            "KHR_materials_unlit",
                                            "KHR_meshopt_compression",
                                            "KHR_node_visibility",
                                            "KHR_texture_basisu",
                                            "KHR_texture_transform",
                                            "VRM",
                                            "VRMC_vrm"};

/// Refuses a document that requires an extension without which its shape or motion would be another one. An extension
/// that changes only how light falls on it, or parts that import does not read, is taken and reported in `repairs`.
/// Throws Refusal.
void check_required_extensions(const nlohmann::json& document, std::vector<std::string>& repairs);

/// Leaves out values that only an extension unknown to import explains, if the file does not require it: channels
/// whose path (KHR_animation_pointer) or interpolation is none of glTF's, and alpha modes. `repairs` names each.
/// Values that no extension explains stay, and check_json refuses them. Does not throw: `document` may hold anything.
void leave_out_unknown_values(nlohmann::json& document, std::vector<std::string>& repairs);

}  // namespace throng::import
