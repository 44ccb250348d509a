#include "engine/anim/import/node_tree.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "engine/anim/import/bytes/refusal.h"

namespace throng::import {

namespace {

std::string node_label(const Document& document, std::size_t node) {
  return label("node", node, document.gltf.nodes[node].name);
}

std::vector<int> find_parents(const Document& document) {
  const auto& nodes = document.gltf.nodes;
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (const int child : nodes[node].children) {
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent >= 0) {
        throw Refusal(node_label(document, static_cast<std::size_t>(child)) + ": has two parents, " +
                      node_label(document, static_cast<std::size_t>(parent)) + " and " + node_label(document, node) +
                      "; export the file again");
      }
      parent = static_cast<int>(node);
    }
  }
  return parents;
}

std::vector<int> order_parents_first(const Document& document, const std::vector<int>& parents) {
  std::vector<int> order;
  for (std::size_t node = 0; node < parents.size(); ++node) {
    if (parents[node] < 0) order.push_back(static_cast<int>(node));
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const auto& children = document.gltf.nodes[static_cast<std::size_t>(order[next])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  if (order.size() != parents.size()) throw Refusal("its nodes form a cycle; export the file again");
  return order;
}

std::vector<bool> find_scene(const Document& document, const NodeTree& tree) {
  const auto& gltf = document.gltf;
  if (gltf.scenes.empty()) return std::vector<bool>(gltf.nodes.size(), true);
  std::vector<bool> in_scene(gltf.nodes.size(), false);
  const int scene = gltf.defaultScene >= 0 ? gltf.defaultScene : 0;
  for (const int root : gltf.scenes[static_cast<std::size_t>(scene)].nodes) {
    in_scene[static_cast<std::size_t>(root)] = true;
  }
  for (const int node : tree.parents_first) {
    const int parent = tree.parents[static_cast<std::size_t>(node)];
    if (parent >= 0 && in_scene[static_cast<std::size_t>(parent)]) in_scene[static_cast<std::size_t>(node)] = true;
  }
  return in_scene;
}

/// KHR_node_visibility: a hidden node hides all below.
std::vector<bool> find_drawn(Document& document, const NodeTree& tree) {
  std::vector<bool> hidden = document.is_hidden;
  std::vector<bool> drawn(hidden.size());
  for (const int node : tree.parents_first) {
    const auto index = static_cast<std::size_t>(node);
    const int parent = tree.parents[index];
    if (parent >= 0 && hidden[static_cast<std::size_t>(parent)]) hidden[index] = true;
    drawn[index] = tree.in_scene[index] && !hidden[index];
    if (tree.in_scene[index] && hidden[index] && document.gltf.nodes[index].mesh >= 0) {
      document.repairs.push_back(node_label(document, index) + ": its mesh is hidden by KHR_node_visibility, left out");
    }
  }
  return drawn;
}

/// Returns translation, rotation and scale of a matrix without shear. A reflection becomes a negative x scale.
std::optional<anim::Transform> decompose(const glm::dmat4& matrix) {
  constexpr double tolerance = 1e-6;
  glm::dmat3 axes(matrix);
  glm::dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  for (int axis = 0; axis < 3; ++axis) {
    if (!(scale[axis] > 0.0)) return std::nullopt;
    axes[axis] /= scale[axis];
  }
  const double shear = std::abs(glm::dot(axes[0], axes[1])) + std::abs(glm::dot(axes[1], axes[2])) +
                       std::abs(glm::dot(axes[2], axes[0]));
  const double projective =
      std::abs(matrix[0][3]) + std::abs(matrix[1][3]) + std::abs(matrix[2][3]) + std::abs(matrix[3][3] - 1.0);
  if (shear > tolerance || projective > 0.0) return std::nullopt;
  if (glm::determinant(axes) < 0.0) {
    scale.x = -scale.x;
    axes[0] = -axes[0];
  }
  return anim::Transform{.translation = glm::vec3(matrix[3]),
                         .rotation = glm::quat(glm::normalize(glm::quat_cast(axes))),
                         .scale = glm::vec3(scale)};
}

NodeTransform from_matrix(const glm::dmat4& matrix) {
  NodeTransform transform{.trs = {}, .matrix = matrix, .has_matrix = true, .is_trs = false};
  if (const auto trs = decompose(matrix)) {
    transform.trs = *trs;
    transform.is_trs = true;
  }
  return transform;
}

NodeTransform read_transform(const Document& document, std::size_t index) {
  const tinygltf::Node& node = document.gltf.nodes[index];
  if (!node.matrix.empty()) return from_matrix(glm::make_mat4(node.matrix.data()));
  glm::dvec3 translation(0.0);
  glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
  glm::dvec3 scale(1.0);
  if (!node.translation.empty()) translation = glm::make_vec3(node.translation.data());
  if (!node.scale.empty()) scale = glm::make_vec3(node.scale.data());
  if (!node.rotation.empty()) {
    rotation = glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (!(glm::length(rotation) > 1e-6)) {
      refuse(node_label(document, index), "its rotation is zero");
    }
    rotation = glm::normalize(rotation);
  }
  return {.trs = {.translation = translation, .rotation = rotation, .scale = scale},
          .matrix = glm::scale(glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(rotation), scale)};
}

}  // namespace

NodeTree build_node_tree(Document& document) {
  NodeTree tree;
  tree.parents = find_parents(document);
  tree.parents_first = order_parents_first(document, tree.parents);
  tree.in_scene = find_scene(document, tree);
  tree.is_drawn = find_drawn(document, tree);
  for (std::size_t node = 0; node < tree.parents.size(); ++node) {
    tree.transforms.push_back(read_transform(document, node));
  }
  tree.globals.resize(tree.parents.size());
  for (const int node : tree.parents_first) {
    const auto index = static_cast<std::size_t>(node);
    const int parent = tree.parents[index];
    const glm::dmat4& local = tree.transforms[index].matrix;
    tree.globals[index] = parent < 0 ? local : tree.globals[static_cast<std::size_t>(parent)] * local;
  }
  return tree;
}

}  // namespace throng::import
