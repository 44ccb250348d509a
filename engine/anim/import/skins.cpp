#include "engine/anim/import/skins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>

#include <glm/gtc/type_ptr.hpp>

#include "engine/anim/import/accessor_reader.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

std::vector<glm::dmat4> read_inverse_binds(Document& document, const tinygltf::Skin& skin, const std::string& name) {
  std::vector<glm::dmat4> matrices(skin.joints.size(), glm::dmat4(1.0));
  if (skin.inverseBindMatrices < 0) return matrices;
  const auto values = read_floats(document, skin.inverseBindMatrices,
                                  {.what = name + ": inverse bind matrices",
                                   .types = {TINYGLTF_TYPE_MAT4},
                                   .components = {TINYGLTF_COMPONENT_TYPE_FLOAT}},
                                  skin.joints.size());
  if (values.size() < matrices.size() * 16) {
    throw Refusal(name + ": has " + std::to_string(values.size() / 16) + " inverse bind matrices for " +
                  std::to_string(matrices.size()) + " joints; export the file again");
  }
  if (!std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) {
    throw Refusal(name + ": an inverse bind matrix is not finite; export the file again");
  }
  bool mended = false;
  for (std::size_t joint = 0; joint < matrices.size(); ++joint) {
    matrices[joint] = glm::dmat4(glm::make_mat4(values.data() + joint * 16));
    for (int column = 0; column < 4; ++column) {
      const double last_row = column == 3 ? 1.0 : 0.0;
      mended = mended || std::abs(matrices[joint][column][3] - last_row) > 1e-6;
      matrices[joint][column][3] = last_row;
    }
  }
  if (mended) document.repairs.push_back(name + ": last rows of inverse bind matrices became 0, 0, 0, 1");
  return matrices;
}

std::vector<int> find_mesh_nodes(const Document& document, int skin) {
  std::vector<int> found;
  for (std::size_t node = 0; node < document.gltf.nodes.size(); ++node) {
    const tinygltf::Node& candidate = document.gltf.nodes[node];
    if (candidate.skin == skin && candidate.mesh >= 0) found.push_back(static_cast<int>(node));
  }
  return found;
}

void check_scene(const FileSkin& skin, const NodeTree& tree, const std::string& name) {
  const auto in_scene = [&](int node) { return tree.in_scene[static_cast<std::size_t>(node)]; };
  if (std::ranges::any_of(skin.mesh_nodes, in_scene) && !std::ranges::all_of(skin.joints, in_scene)) {
    throw Refusal(name + ": the scene draws it, but does not hold all of its joints; add them to the scene");
  }
}

int find_group(std::vector<int>& groups, int skin) {
  while (groups[static_cast<std::size_t>(skin)] != skin) {
    int& group = groups[static_cast<std::size_t>(skin)];
    group = groups[static_cast<std::size_t>(group)];
    skin = group;
  }
  return skin;
}

/// Joins two groups under the smaller index, so that groups keep the order of the file.
void join_groups(std::vector<int>& groups, int a, int b) {
  const int first = find_group(groups, a);
  const int second = find_group(groups, b);
  groups[static_cast<std::size_t>(std::max(first, second))] = std::min(first, second);
}

}  // namespace

std::vector<FileSkin> read_skins(Document& document, const NodeTree& tree) {
  std::vector<FileSkin> skins;
  for (std::size_t index = 0; index < document.gltf.skins.size(); ++index) {
    const tinygltf::Skin& source = document.gltf.skins[index];
    const std::string name = label("skin", index, source.name);
    skins.push_back({.index = static_cast<int>(index),
                     .name = source.name,
                     .joints = source.joints,
                     .inverse_binds = read_inverse_binds(document, source, name),
                     .mesh_nodes = find_mesh_nodes(document, static_cast<int>(index))});
    check_scene(skins.back(), tree, name);
  }
  return skins;
}

std::vector<std::vector<int>> group_skins(const std::vector<FileSkin>& skins, const NodeTree& tree) {
  std::vector<int> groups(skins.size());
  std::iota(groups.begin(), groups.end(), 0);
  std::vector<int> skin_of_node(tree.parents.size(), -1);
  for (std::size_t skin = 0; skin < skins.size(); ++skin) {
    for (const int joint : skins[skin].joints) {
      int& first = skin_of_node[static_cast<std::size_t>(joint)];
      if (first < 0) first = static_cast<int>(skin);
      join_groups(groups, first, static_cast<int>(skin));
    }
  }
  // Parents come first, so each node hands down the skin of the nearest joint at or above it.
  for (const int node : tree.parents_first) {
    const int parent = tree.parents[static_cast<std::size_t>(node)];
    if (parent < 0) continue;
    const int above = skin_of_node[static_cast<std::size_t>(parent)];
    int& own = skin_of_node[static_cast<std::size_t>(node)];
    if (own < 0) own = above;
    if (above >= 0) join_groups(groups, own, above);
  }
  std::map<int, std::vector<int>> members;
  for (std::size_t skin = 0; skin < skins.size(); ++skin) {
    members[find_group(groups, static_cast<int>(skin))].push_back(static_cast<int>(skin));
  }
  std::vector<std::vector<int>> result;
  for (auto& [leader, group] : members) result.push_back(std::move(group));
  return result;
}

}  // namespace throng::import
