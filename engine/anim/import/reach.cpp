#include "engine/anim/import/reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

/// Leaves room for the products that posing makes of two such numbers.
constexpr double furthest = 1e18;

/// The most that a node's transform moves and stretches the nodes below it.
struct Reach {
  double distance = 0.0;
  double stretch = 1.0;
};

/// Takes a value that is not a number for the largest of all.
double larger(double a, double b) { return b <= a ? a : b; }

double largest_component(const glm::vec3& vector) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) largest = larger(largest, std::abs(static_cast<double>(vector[axis])));
  return largest;
}

double largest_value(const anim::Track<glm::vec3>& track) {
  double largest = 0.0;
  for (const glm::vec3& value : track.values) largest = larger(largest, largest_component(value));
  return largest;
}

Reach reach_of(const glm::dmat4& matrix) {
  Reach reach{.distance = 0.0, .stretch = 0.0};
  for (int row = 0; row < 3; ++row) {
    reach.distance = larger(reach.distance, std::abs(matrix[3][row]));
    for (int column = 0; column < 3; ++column) reach.stretch = larger(reach.stretch, std::abs(matrix[column][row]));
  }
  return reach;
}

std::vector<Reach> local_reaches(const NodeTree& tree, const std::vector<Animation>& animations) {
  std::vector<Reach> reaches;
  for (const NodeTransform& transform : tree.transforms) reaches.push_back(reach_of(transform.matrix));
  for (const Animation& animation : animations) {
    for (const auto& [node, tracks] : animation.nodes) {
      Reach& reach = reaches[static_cast<std::size_t>(node)];
      reach.distance = larger(reach.distance, largest_value(tracks.translation));
      reach.stretch = larger(reach.stretch, largest_value(tracks.scale));
    }
  }
  return reaches;
}

[[noreturn]] void refuse_node(const Document& document, std::size_t node) {
  refuse(label("node", node, document.gltf.nodes[node].name),
         "its transform, with those of its parents and its keys, leads further than numbers reach");
}

void check_inverse_binds(const Document& document, const FileSkin& skin, const std::vector<Reach>& reaches) {
  for (std::size_t joint = 0; joint < skin.joints.size(); ++joint) {
    const auto node = static_cast<std::size_t>(skin.joints[joint]);
    const Reach bind = reach_of(skin.inverse_binds[joint]);
    const double distance = reaches[node].distance + reaches[node].stretch * larger(bind.distance, bind.stretch);
    if (!(distance <= furthest)) refuse_node(document, node);
  }
}

}  // namespace

void check_reach(const Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                 const std::vector<FileSkin>& skins) {
  std::vector<Reach> reaches = local_reaches(tree, animations);
  for (const int index : tree.parents_first) {
    const auto node = static_cast<std::size_t>(index);
    Reach& reach = reaches[node];
    if (const int parent = tree.parents[node]; parent >= 0) {
      const Reach& above = reaches[static_cast<std::size_t>(parent)];
      reach.distance = above.distance + above.stretch * reach.distance;
      reach.stretch *= above.stretch;
    }
    if (!(reach.distance <= furthest && reach.stretch <= furthest)) refuse_node(document, node);
  }
  for (const FileSkin& skin : skins) check_inverse_binds(document, skin, reaches);
}

}  // namespace throng::import
