#include "engine/anim/import/skeleton_builder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "engine/anim/asset/reference_frames.h"
#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/memory/model_memory.h"

namespace throng::import {

namespace {

std::vector<glm::dmat4> read_inverse_binds(Document& document, const tinygltf::Skin& skin, const std::string& name) {
  document.memory->charge(skin.joints.size() * (sizeof(glm::dmat4) + sizeof(int)), name);
  const MemoryScope scope(*document.memory);  // of their floats
  std::vector<glm::dmat4> matrices(skin.joints.size(), glm::dmat4(1.0));
  if (skin.inverseBindMatrices < 0) return matrices;
  const auto values =
      read_floats(document, skin.inverseBindMatrices,
                  {name + ": inverse bind matrices", {TINYGLTF_TYPE_MAT4}, float_alone}, skin.joints.size());
  if (values.size() < matrices.size() * 16) {
    refuse(name, "has " + std::to_string(values.size() / 16) + " inverse bind matrices for " +
                     std::to_string(matrices.size()) + " joints");
  }
  if (!all_finite(values)) refuse(name, "an inverse bind matrix is not finite");
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

using NodeSet = std::vector<bool>;

bool has(const NodeSet& set, int node) { return set[static_cast<std::size_t>(node)]; }
std::size_t count(const NodeSet& set) { return static_cast<std::size_t>(std::ranges::count(set, true)); }

class SkeletonBuilder {
 public:
  SkeletonBuilder(const Document& document, const NodeTree& tree, std::vector<Animation>& animations)
      : document_(document), tree_(tree), animations_(animations), bone_of_node_(tree.parents.size(), -1) {}

  BuiltSkeleton build(const std::vector<FileSkin>& skins, const std::vector<int>& group,
                      const std::vector<int>& carried) {
    const NodeSet joints = find_joints(skins, group);
    NodeSet attached = find_attached(joints);
    for (const int node : carried) attached[static_cast<std::size_t>(node)] = true;
    const NodeSet bone_nodes = find_bone_nodes(joints, attached);
    document_.memory->charge(skeleton_memory(count(bone_nodes), count(attached)), "a skeleton");
    add_bones(bone_nodes);
    add_attached(attached, bone_nodes);
    check_bone_count();
    add_skins(skins, group);
    add_clips(joints);
    built_.skeleton.name = built_.skins.front().name;
    std::vector<int> attached_bones;
    for (const AttachedMesh& mesh : built_.attached) attached_bones.push_back(mesh.bone);
    set_reference_frames(built_.skeleton, built_.skins, built_.clips, attached_bones);
    return std::move(built_);
  }

 private:
  NodeSet find_joints(const std::vector<FileSkin>& skins, const std::vector<int>& group) const {
    NodeSet joints(tree_.parents.size(), false);
    for (const int skin : group) {
      for (const int joint : skins[static_cast<std::size_t>(skin)].joints) {
        joints[static_cast<std::size_t>(joint)] = true;
      }
    }
    return joints;
  }

  /// Finds drawn mesh nodes without skin, at or below a joint.
  NodeSet find_attached(const NodeSet& joints) const {
    NodeSet below = joints;
    NodeSet attached(joints.size(), false);
    for (const int node : tree_.parents_first) {
      const auto index = static_cast<std::size_t>(node);
      const int parent = tree_.parents[index];
      if (parent >= 0 && has(below, parent)) below[index] = true;
      const tinygltf::Node& source = document_.gltf.nodes[index];
      attached[index] = below[index] && tree_.is_drawn[index] && source.mesh >= 0 && source.skin < 0;
    }
    return attached;
  }

  NodeSet find_bone_nodes(const NodeSet& joints, const NodeSet& attached) const {
    NodeSet animated(joints.size(), false);
    for (const Animation& animation : animations_) {
      for (const auto& [node, tracks] : animation.nodes) {
        if (bytes_of(tracks) > 0) animated[static_cast<std::size_t>(node)] = true;
      }
    }
    NodeSet leads(joints.size(), false);
    NodeSet bones = joints;
    for (std::size_t i = tree_.parents_first.size(); i-- > 0;) {
      const auto node = static_cast<std::size_t>(tree_.parents_first[i]);
      leads[node] = leads[node] || joints[node] || attached[node];
      bones[node] = bones[node] || (leads[node] && animated[node]);
      if (leads[node] && tree_.parents[node] >= 0) leads[static_cast<std::size_t>(tree_.parents[node])] = true;
    }
    return bones;
  }

  /// Returns the nearest node at or above `node` that is in `bones`, or -1; `chain` gets the transforms on the way.
  int climb(int node, const NodeSet& bones, glm::dmat4& chain) const {
    while (node >= 0 && !has(bones, node)) {
      chain = tree_.transforms[static_cast<std::size_t>(node)].matrix * chain;
      node = tree_.parents[static_cast<std::size_t>(node)];
    }
    return node;
  }

  /// Adds bones, parents first. The order by level of detail comes later, when the surface is known.
  void add_bones(const NodeSet& bone_nodes) {
    std::vector<anim::Bone>& bones = built_.skeleton.bones;
    for (const int node : tree_.parents_first) {
      if (!has(bone_nodes, node)) continue;
      const auto index = static_cast<std::size_t>(node);
      const NodeTransform& transform = tree_.transforms[index];
      anim::Bone bone;
      bone.name = document_.gltf.nodes[index].name;
      bone.node = node;
      if (!document_.humanoid.roles.empty()) bone.role = document_.humanoid.roles[index];
      const int above = climb(tree_.parents[index], bone_nodes, bone.prefix);
      bone.parent = above < 0 ? -1 : bone_of_node_[static_cast<std::size_t>(above)];
      bone.rest = transform.trs;
      bone.prefix_holds_matrix = !transform.is_trs;
      if (bone.prefix_holds_matrix) bone.prefix = bone.prefix * transform.matrix;
      bone_of_node_[index] = static_cast<int>(bones.size());
      bones.push_back(std::move(bone));
    }
  }

  void check_bone_count() {
    const int bones = built_.skeleton.bone_count();
    if (bones > anim::max_bones) {
      throw Refusal("a skeleton has " + std::to_string(bones) + " bones, more than " + std::to_string(anim::max_bones) +
                    "; split the model");
    }
    built_.skeleton.level_bone_counts = {bones};
  }

  void add_skins(const std::vector<FileSkin>& skins, const std::vector<int>& group) {
    for (const int index : group) {
      const FileSkin& source = skins[static_cast<std::size_t>(index)];
      document_.memory->charge(skin_memory(source.joints.size()), "skin " + std::to_string(source.index));
      anim::Skin skin{.skin = source.index,
                      .name = source.name,
                      .bones = {},
                      .palette_entries = {},
                      .inverse_binds = source.inverse_binds,
                      .bind_to_model = glm::dmat4(1.0),
                      .mesh_nodes = source.mesh_nodes};
      for (const int joint : source.joints) skin.bones.push_back(bone_of_node_[static_cast<std::size_t>(joint)]);
      built_.skins.push_back(std::move(skin));
    }
  }

  /// Takes the tracks of joints, which no other skeleton has, and copies the tracks of nodes above.
  void add_clips(const NodeSet& joints) {
    for (std::size_t index = 0; index < animations_.size(); ++index) {
      Animation& animation = animations_[index];
      const std::string name = label("animation", index, animation.clip.name);
      document_.memory->charge(clip_memory(animation.clip), name);
      anim::Clip clip = animation.clip;
      for (auto& [node, tracks] : animation.nodes) {
        const int bone = bone_of_node_[static_cast<std::size_t>(node)];
        if (bone < 0) continue;
        const bool is_own = has(joints, node);
        document_.memory->charge((is_own ? 0 : bytes_of(tracks)) + 3 * sizeof(anim::BoneTracks), name);
        clip.tracks.push_back(is_own ? std::exchange(tracks, {}) : tracks);
        clip.tracks.back().bone = bone;
      }
      std::ranges::sort(clip.tracks, {}, &anim::BoneTracks::bone);
      if (!clip.tracks.empty()) built_.clips.push_back(std::move(clip));
    }
  }

  void add_attached(const NodeSet& attached, const NodeSet& bone_nodes) {
    for (int node = 0; node < tree_.size(); ++node) {
      if (!has(attached, node)) continue;
      AttachedMesh mesh{.node = node};
      const int above = climb(node, bone_nodes, mesh.to_bone);
      mesh.bone = above < 0 ? scene_bone() : bone_of_node_[static_cast<std::size_t>(above)];
      built_.attached.push_back(mesh);
    }
  }

  /// Returns the bone that never moves, which no node stands for.
  int scene_bone() {
    if (scene_bone_ < 0) {
      scene_bone_ = built_.skeleton.bone_count();
      built_.skeleton.bones.push_back({.name = "scene", .rest = {}});
      built_.skeleton.level_bone_counts = {built_.skeleton.bone_count()};
    }
    return scene_bone_;
  }

  const Document& document_;
  const NodeTree& tree_;
  std::vector<Animation>& animations_;
  std::vector<int> bone_of_node_;
  int scene_bone_ = -1;
  BuiltSkeleton built_;
};

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

std::vector<FileSkin> skin_animated_nodes(const Document& document, const NodeTree& tree,
                                          const std::vector<Animation>& animations) {
  const std::size_t nodes = tree.parents.size();
  NodeSet moves(nodes, false), leads(nodes, false);
  for (const Animation& animation : animations) {
    for (const auto& [node, tracks] : animation.nodes) {
      moves[static_cast<std::size_t>(node)] = document.gltf.nodes[static_cast<std::size_t>(node)].mesh < 0;
    }
  }
  const auto parent_of = [&](std::size_t node) { return tree.parents[node]; };
  leads = moves;
  for (std::size_t i = nodes; i-- > 0;) {  // a node with a moving node below it
    const auto node = static_cast<std::size_t>(tree.parents_first[i]);
    if (leads[node] && parent_of(node) >= 0) leads[static_cast<std::size_t>(parent_of(node))] = true;
  }
  std::map<int, FileSkin> skins;  // by the root of the tree
  std::vector<int> roots(nodes);
  for (const int node : tree.parents_first) {
    const auto index = static_cast<std::size_t>(node);
    const int parent = parent_of(index);
    roots[index] = parent < 0 ? node : roots[static_cast<std::size_t>(parent)];
    const bool follows = parent >= 0 && has(moves, parent) && document.gltf.nodes[index].mesh < 0;
    moves[index] = moves[index] || follows;
    if (!moves[index] && !leads[index]) continue;
    if (glm::determinant(tree.globals[index]) == 0.0) continue;  // no bind pose
    FileSkin& skin = skins[roots[index]];
    skin.name = document.gltf.nodes[static_cast<std::size_t>(roots[index])].name;
    skin.joints.push_back(node);
    skin.inverse_binds.push_back(glm::inverse(tree.globals[index]));
  }
  std::vector<FileSkin> found;
  for (auto& [root, skin] : skins) {
    skin.index = -1 - static_cast<int>(found.size());  // none of the file's
    found.push_back(std::move(skin));
  }
  return found;
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

BuiltSkeleton build_skeleton(const Document& document, const NodeTree& tree, std::vector<Animation>& animations,
                             const std::vector<FileSkin>& skins, const std::vector<int>& group,
                             const std::vector<int>& carried) {
  return SkeletonBuilder(document, tree, animations).build(skins, group, carried);
}

}  // namespace throng::import
