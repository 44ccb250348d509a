#pragma once

#include <string>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/animations.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/skins.h"

namespace throng::import {

/// A mesh node without skin that hangs below a bone.
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

/// Builds a skeleton. Bones are the joints of the skins, and every animated node between or above them or the meshes
/// that hang below them. Nodes in between that never move become Bone::prefix. set_reference_frames sets references and
/// palette. Throws Refusal where there are more than anim::max_bones.
BuiltSkeleton build_skeleton(const Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                             const std::vector<FileSkin>& skins, const std::vector<int>& group);

}  // namespace throng::import
