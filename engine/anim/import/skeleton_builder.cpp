#include "engine/anim/import/skeleton_builder.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/anim/import/reference_frames.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using NodeSet = std::vector<bool>;

bool has(const NodeSet& set, int node) { return set[static_cast<std::size_t>(node)]; }

class SkeletonBuilder {
 public:
  SkeletonBuilder(const Document& document, const NodeTree& tree, const std::vector<Animation>& animations)
      : document_(document), tree_(tree), animations_(animations), bone_of_node_(tree.parents.size(), -1) {}

  BuiltSkeleton build(const std::vector<FileSkin>& skins, const std::vector<int>& group) {
    const NodeSet joints = find_joints(skins, group);
    const NodeSet attached = find_attached(joints);
    add_bones(find_bone_nodes(joints, attached));
    add_skins(skins, group);
    add_clips();
    add_attached(attached);
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

  /// Finds mesh nodes of the scene without skin, at or below a joint.
  NodeSet find_attached(const NodeSet& joints) const {
    NodeSet below = joints;
    NodeSet attached(joints.size(), false);
    for (const int node : tree_.parents_first) {
      const auto index = static_cast<std::size_t>(node);
      const int parent = tree_.parents[index];
      if (parent >= 0 && has(below, parent)) below[index] = true;
      const tinygltf::Node& source = document_.gltf.nodes[index];
      attached[index] = below[index] && tree_.in_scene[index] && source.mesh >= 0 && source.skin < 0;
    }
    return attached;
  }

  NodeSet find_bone_nodes(const NodeSet& joints, const NodeSet& attached) const {
    NodeSet animated(joints.size(), false);
    for (const Animation& animation : animations_) {
      for (const auto& [node, tracks] : animation.nodes) {
        animated[static_cast<std::size_t>(node)] = animated[static_cast<std::size_t>(node)] ||
                                                   !tracks.translation.empty() || !tracks.rotation.empty() ||
                                                   !tracks.scale.empty();
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
      const int above = climb(tree_.parents[index], bone_nodes, bone.prefix);
      bone.parent = above < 0 ? -1 : bone_of_node_[static_cast<std::size_t>(above)];
      bone.rest = transform.trs;
      bone.prefix_holds_matrix = !transform.is_trs;
      if (bone.prefix_holds_matrix) bone.prefix = bone.prefix * transform.matrix;
      bone_of_node_[index] = static_cast<int>(bones.size());
      bones.push_back(std::move(bone));
    }
    if (bones.size() > static_cast<std::size_t>(anim::max_bones)) {
      throw Refusal("a skeleton has " + std::to_string(bones.size()) + " bones, more than " +
                    std::to_string(anim::max_bones) + "; split the model");
    }
    built_.skeleton.level_bone_counts = {built_.skeleton.bone_count()};
  }

  void add_skins(const std::vector<FileSkin>& skins, const std::vector<int>& group) {
    for (const int index : group) {
      const FileSkin& source = skins[static_cast<std::size_t>(index)];
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

  void add_clips() {
    for (std::size_t index = 0; index < animations_.size(); ++index) {
      const Animation& animation = animations_[index];
      anim::Clip clip{.name = animation.name,
                      .animation = static_cast<int>(index),
                      .start = animation.start,
                      .duration = animation.duration,
                      .tracks = {},
                      .data_keys = animation.data_keys};
      for (const auto& [node, tracks] : animation.nodes) {
        const int bone = bone_of_node_[static_cast<std::size_t>(node)];
        if (bone < 0) continue;
        clip.tracks.push_back(
            {.bone = bone, .translation = tracks.translation, .rotation = tracks.rotation, .scale = tracks.scale});
      }
      std::ranges::sort(clip.tracks, {}, &anim::BoneTracks::bone);
      if (!clip.tracks.empty()) built_.clips.push_back(std::move(clip));
    }
  }

  void add_attached(const NodeSet& attached) {
    NodeSet bones(bone_of_node_.size(), false);
    for (std::size_t node = 0; node < bones.size(); ++node) bones[node] = bone_of_node_[node] >= 0;
    for (int node = 0; node < tree_.size(); ++node) {
      if (!has(attached, node)) continue;
      AttachedMesh mesh{.node = node};
      mesh.bone = bone_of_node_[static_cast<std::size_t>(climb(node, bones, mesh.to_bone))];
      built_.attached.push_back(mesh);
    }
  }

  const Document& document_;
  const NodeTree& tree_;
  const std::vector<Animation>& animations_;
  std::vector<int> bone_of_node_;
  BuiltSkeleton built_;
};

}  // namespace

BuiltSkeleton build_skeleton(const Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                             const std::vector<FileSkin>& skins, const std::vector<int>& group) {
  return SkeletonBuilder(document, tree, animations).build(skins, group);
}

}  // namespace throng::import
