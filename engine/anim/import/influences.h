#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Four influences a vertex, strongest first. Their weights sum to 1.
struct Influences {
  std::vector<glm::u16vec4> palette_entries;
  std::vector<glm::vec4> weights;
};

inline constexpr std::size_t bytes_an_influence = sizeof(glm::u16vec4) + sizeof(glm::vec4);  // of a vertex

/// Reads every JOINTS_n and WEIGHTS_n of a primitive. Messages and repairs call the primitive `name`. Weights that are
/// not finite count as 0, influences beyond four are dropped, weights that do not sum to 1 are normalised, and a vertex
/// without weights follows the first joint; repairs report all of this. Throws Refusal.
Influences read_influences(Document& document, const tinygltf::Primitive& primitive, const anim::Skin& skin,
                           std::size_t vertex_count, const std::string& name);

/// Binds every vertex to one palette entry.
Influences rigid_influences(int palette_entry, std::size_t vertex_count);

}  // namespace throng::import
