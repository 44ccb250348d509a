#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/animations.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"

namespace throng::import {

/// A skin as the file has it.
struct FileSkin {
  int index = 0;
  std::string name;
  std::vector<int> joints;                ///< nodes
  std::vector<glm::dmat4> inverse_binds;  ///< one a joint; identity where the file has none
  std::vector<int> mesh_nodes;            ///< nodes that draw a mesh with it, in the scene or not
};

/// Reads all skins. Throws Refusal, also where the scene draws a skin without holding its joints.
std::vector<FileSkin> read_skins(Document& document, const NodeTree& tree);

/// Makes a skin of each tree of nodes that holds an animated one, for files of clips alone. Its joints are the animated
/// nodes without a mesh and those above and below them; its bind pose is the rest pose.
std::vector<FileSkin> skin_animated_nodes(const Document& document, const NodeTree& tree,
                                          const std::vector<Animation>& animations);

/// Groups skins that move together: two share a group if a joint of one is a joint, an ancestor or a descendant of a
/// joint of the other. Returns indices into `skins`, ascending inside a group.
std::vector<std::vector<int>> group_skins(const std::vector<FileSkin>& skins, const NodeTree& tree);

/// A mesh node without skin, and the bone that carries it.
struct AttachedMesh {
  int node = 0;
  int bone = 0;
  glm::dmat4 to_bone{1.0};  ///< vertex space -> space of the bone
};

/// A group of skins, made into a skeleton.
struct BuiltSkeleton {
  anim::Skeleton skeleton;
  std::vector<anim::Skin> skins;
  std::vector<anim::Clip> clips;
  std::vector<AttachedMesh> attached;
};

/// Builds a skeleton that carries the meshes without skin below its joints, and the meshes of the nodes `carried`.
/// Bones are the joints of the skins, and every animated node between or above them or those meshes. Nodes in between
/// that never move become Bone::prefix. Meshes that nothing moves hang on one bone more, the scene.
/// set_reference_frames sets references and palette. Moves the tracks of joints out of `animations`. Throws Refusal
/// where there are more than anim::max_bones.
BuiltSkeleton build_skeleton(const Document& document, const NodeTree& tree, std::vector<Animation>& animations,
                             const std::vector<FileSkin>& skins, const std::vector<int>& group,
                             const std::vector<int>& carried);

}  // namespace throng::import
