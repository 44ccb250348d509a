#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/base/result.h"

namespace throng::anim {

struct Model;

/// A transform that an update writes: global * post. `global` is the joint of a bone in model space, as glTF 2.0
/// (3.5.3) defines it. `post` is constant: the identity for the joint itself, the place of a socket in the joint's own
/// frame, or the inverse bind matrix of a skin.
struct ListedJoint {
  int bone = 0;
  glm::dmat4 post{1.0};
};

/// The transforms that updates write for each agent of a character, in this order. A bone may be listed several times.
using JointList = std::vector<ListedJoint>;

/// Lists every bone of a skeleton, in its order.
JointList all_joints(const Skeleton& skeleton);

/// Lists these bones. Errors: the skeleton lacks one of them.
Result<JointList> joints_of(const Skeleton& skeleton, std::span<const int> bones);

/// Lists the matrices of a glTF skin in the order of its `joints`, global * inverse bind matrix (glTF 2.0, 3.7.3.3), so
/// that JOINTS_0 of the file's own vertices names their places. `skin` is the index in the file, as in Skin::skin.
/// Lists of several skins are put one behind the other. Errors: the model has no such skin.
Result<JointList> joints_of_skin(const Model& model, int skin);

/// Returns the joint of a bone in the bind pose, model space, on a rigid skeleton.
glm::dmat4 bind_global(const Skeleton& skeleton, int bone);

}  // namespace throng::anim
