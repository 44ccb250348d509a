#include "engine/anim/survey/entry_boxes.h"

#include <cassert>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/survey/surface_points.h"

namespace throng::anim {
namespace {

void add_surface(const SkinnedMesh& mesh, std::vector<Box>& boxes) {
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    for (int i = 0; i < 4; ++i) {
      if (mesh.weights[vertex][i] != 0.0F) boxes[mesh.palette_entries[vertex][i]].add(mesh.positions[vertex]);
    }
  }
}

}  // namespace

std::vector<Box> entry_boxes(const Model& model) {
  std::vector<Box> boxes(model.skeleton.palette.size());
  bool has_surface = false;
  for (const SkinnedMesh& mesh : model.meshes) {
    add_surface(mesh, boxes);
    has_surface = has_surface || !mesh.positions.empty();
  }
  if (has_surface) return boxes;
  for (const PointInfluence& joint : sample_surface(model, 1).influences) {
    boxes[joint.entry].add(glm::vec3(joint.weighted));
  }
  return boxes;
}

// A vertex lies between the places to which its entries take it, and a box holds what lies between its points.
Box posed_box(std::span<const Box> entry_boxes, std::span<const PaletteMatrix> palette) {
  assert(entry_boxes.size() == palette.size());
  Box posed;
  for (std::size_t entry = 0; entry < palette.size(); ++entry) {
    if (entry_boxes[entry].is_empty()) continue;
    const glm::dvec3 middle = entry_boxes[entry].middle(), half = 0.5 * entry_boxes[entry].size();
    glm::dvec3 place, reach;
    for (int axis = 0; axis < 3; ++axis) {
      const float* const row = palette[entry].rows[axis];
      const glm::dvec3 turn(row[0], row[1], row[2]);
      place[axis] = glm::dot(turn, middle) + static_cast<double>(row[3]);
      reach[axis] = glm::dot(glm::abs(turn), half);
    }
    posed.add(place - reach);
    posed.add(place + reach);
  }
  return posed;
}

}  // namespace throng::anim
