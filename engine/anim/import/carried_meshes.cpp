#include "engine/anim/import/carried_meshes.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include <glm/geometric.hpp>

#include "engine/anim/base/box.h"
#include "engine/anim/import/accessors.h"

namespace throng::import {

namespace {

using anim::Box;

constexpr double surroundings = 1.0;   // to each side, of the body's largest side: hats, guns and turrets lie within
constexpr double largest_part = 1.5;   // of the body's largest side: a floor is larger
constexpr std::size_t most_names = 4;  // of meshes in one sentence
constexpr int no_group = -1;
constexpr int several_groups = -2;

double largest_side(const Box& box) { return std::max({box.size().x, box.size().y, box.size().z}); }

/// Returns whether a box that is so much wider on each side holds the other.
bool holds(const Box& box, double widened, const Box& other) {
  return glm::all(glm::lessThanEqual(box.low - widened, other.low)) &&
         glm::all(glm::greaterThanEqual(box.high + widened, other.high));
}

class MeshSorter {
 public:
  MeshSorter(Document& document, const NodeTree& tree, const std::vector<FileSkin>& skins,
             const std::vector<std::vector<int>>& groups)
      : document_(document), tree_(tree), skins_(skins), groups_(groups), below_joint_(tree.parents.size(), false) {}

  std::vector<std::vector<int>> sort() {
    std::vector<std::vector<int>> carried(groups_.size());
    mark_joints();
    for (int node = 0; node < tree_.size(); ++node) {
      if (!is_loose_mesh(node)) continue;
      const int group = group_that_carries(node);
      if (group >= 0) {
        carried[static_cast<std::size_t>(group)].push_back(node);
      } else {
        left_out_.push_back(node);
      }
    }
    report();
    return carried;
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  /// Marks nodes at or below joints, and finds the one skeleton that has parts below each node.
  void mark_joints() {
    group_below_.assign(tree_.parents.size(), no_group);
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      for (const int skin : groups_[group]) {
        for (const int joint : skins_[at(skin)].joints) {
          below_joint_[at(joint)] = true;
          group_below_[at(joint)] = static_cast<int>(group);
        }
      }
    }
    for (const int node : tree_.parents_first) {
      const int parent = tree_.parents[at(node)];
      if (parent >= 0 && below_joint_[at(parent)]) below_joint_[at(node)] = true;
    }
    for (std::size_t i = tree_.parents_first.size(); i-- > 0;) {
      const int node = tree_.parents_first[i];
      const int parent = tree_.parents[at(node)];
      if (parent >= 0) group_below_[at(parent)] = joined(group_below_[at(parent)], group_below_[at(node)]);
    }
  }

  static int joined(int a, int b) {
    if (a == no_group || a == b) return b;
    return b == no_group ? a : several_groups;
  }

  bool is_loose_mesh(int node) const {
    const tinygltf::Node& source = document_.gltf.nodes[at(node)];
    return tree_.is_drawn[at(node)] && source.mesh >= 0 && source.skin < 0 && !below_joint_[at(node)];
  }

  int group_that_carries(int node) {
    const Box box = box_of(document_.gltf.nodes[at(node)].mesh, tree_.globals[at(node)]);
    if (box.is_empty()) return no_group;
    const int together = group_beside(node);
    int nearest = no_group;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      if (together >= 0 && together != static_cast<int>(group)) continue;
      const Box& body = body_of(group);
      if (body.is_empty() || !may_carry(body, box)) continue;
      const double distance = glm::distance(body.middle(), box.middle());
      if (distance >= shortest) continue;
      shortest = distance;
      nearest = static_cast<int>(group);
    }
    return nearest;
  }

  static bool may_carry(const Box& body, const Box& mesh) {
    const double side = largest_side(body);
    return largest_side(mesh) <= largest_part * side && holds(body, surroundings * side, mesh);
  }

  /// Returns the only skeleton below the nearest node above that has any below it.
  int group_beside(int node) const {
    while (node >= 0 && group_below_[at(node)] == no_group) node = tree_.parents[at(node)];
    return node < 0 ? no_group : group_below_[at(node)];
  }

  /// Returns the room of a skeleton in the rest pose. Its skins follow their first joints.
  const Box& body_of(std::size_t group) {
    bodies_.resize(groups_.size());
    if (bodies_[group]) return *bodies_[group];
    Box body;
    for (const int index : groups_[group]) {
      const FileSkin& skin = skins_[at(index)];
      for (const int joint : skin.joints) body.add(glm::dvec3(tree_.globals[at(joint)][3]));
      const glm::dmat4 bind = tree_.globals[at(skin.joints.front())] * skin.inverse_binds.front();
      for (const int node : skin.mesh_nodes) {
        const Box box = box_of(document_.gltf.nodes[at(node)].mesh, bind);
        if (box.is_empty()) continue;
        body.add(box.low);
        body.add(box.high);
      }
    }
    return bodies_[group].emplace(body);
  }

  /// Returns the room of a mesh, by the bounds that its accessors state (glTF 2.0, 3.6.2.5: POSITION must have them).
  Box box_of(int mesh, const glm::dmat4& placement) const {
    Box box;
    for (const tinygltf::Primitive& primitive : document_.gltf.meshes[at(mesh)].primitives) {
      const auto positions = primitive.attributes.find("POSITION");
      if (positions == primitive.attributes.end()) continue;
      const tinygltf::Accessor& accessor = accessor_at(document_, positions->second);
      if (accessor.minValues.size() != 3 || accessor.maxValues.size() != 3) continue;
      const double unit = accessor.normalized ? normalised_unit(accessor.componentType) : 1.0;
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec4 point(1.0);
        for (int axis = 0; axis < 3; ++axis) {
          const auto& bound = (corner >> axis & 1) == 0 ? accessor.minValues : accessor.maxValues;
          point[axis] = bound[at(axis)] * unit;
        }
        box.add(glm::dvec3(placement * point));
      }
    }
    return box;
  }

  static double normalised_unit(int component) {
    switch (component) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return 1.0 / 127.0;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1.0 / 255.0;
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return 1.0 / 32767.0;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 1.0 / 65535.0;
      default:
        return 1.0;
    }
  }

  void report() {
    if (left_out_.empty() || groups_.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < left_out_.size() && i < most_names; ++i) {
      if (i > 0) names += ", ";
      names += label("node", at(left_out_[i]), document_.gltf.nodes[at(left_out_[i])].name);
    }
    if (left_out_.size() > most_names) names += " and others";
    const bool one = left_out_.size() == 1;
    document_.repairs.push_back((one ? std::string("a mesh is") : std::to_string(left_out_.size()) + " meshes are") +
                                " left out as scenery, too far from every skeleton or too large for it: " + names +
                                "; to keep " + (one ? "it" : "them") + ", hang " + (one ? "it" : "them") +
                                " below a joint");
  }

  Document& document_;
  const NodeTree& tree_;
  const std::vector<FileSkin>& skins_;
  const std::vector<std::vector<int>>& groups_;
  std::vector<bool> below_joint_;
  std::vector<int> group_below_;            // by node: the skeleton, no_group or several_groups
  std::vector<std::optional<Box>> bodies_;  // by group
  std::vector<int> left_out_;
};

}  // namespace

std::vector<std::vector<int>> find_carried_meshes(Document& document, const NodeTree& tree,
                                                  const std::vector<FileSkin>& skins,
                                                  const std::vector<std::vector<int>>& groups) {
  return MeshSorter(document, tree, skins, groups).sort();
}

}  // namespace throng::import
