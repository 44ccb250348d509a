#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Four influences a vertex, strongest first, weights summing to 1.
struct Influences {
  std::vector<glm::u16vec4> palette_entries;
  std::vector<glm::vec4> weights;
};

/// Reads every JOINTS_n and WEIGHTS_n of a primitive; `name` is the primitive's in messages and repairs. What is beyond
/// four influences is dropped, what does not sum to 1 is normalised, a vertex without any follows the first joint; all
/// that is reported. Throws Refusal.
Influences read_influences(Document& document, const tinygltf::Primitive& primitive, const anim::Skin& skin,
                           std::size_t vertex_count, const std::string& name);

/// Every vertex bound to one palette entry.
Influences rigid_influences(int palette_entry, std::size_t vertex_count);

}  // namespace throng::import
