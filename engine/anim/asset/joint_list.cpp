#include "engine/anim/asset/joint_list.h"

#include <algorithm>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {
namespace {

Status find_bone(const Skeleton& skeleton, int bone) {
  if (bone >= 0 && bone < skeleton.bone_count()) return Done{};
  return Error{"\"" + skeleton.name + "\" has no bone " + std::to_string(bone) + ": give 0 to " +
               std::to_string(skeleton.bone_count() - 1)};
}

}  // namespace

glm::dmat4 bind_global(const Skeleton& skeleton, int bone) {
  const ReferenceFrame& frame = skeleton.references[static_cast<std::size_t>(bone)];
  const glm::dmat4 turned = glm::translate(glm::dmat4(1.0), frame.origin) * glm::mat4_cast(frame.rotation);
  return glm::scale(turned, glm::dvec3(frame.scale));
}

JointList all_joints(const Skeleton& skeleton) {
  JointList list;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) list.push_back({.bone = bone});
  return list;
}

Result<JointList> joints_of(const Skeleton& skeleton, std::span<const int> bones) {
  JointList list;
  for (const int bone : bones) {
    if (Status found = find_bone(skeleton, bone); !found) return found.error();
    list.push_back({.bone = bone});
  }
  return list;
}

Result<JointList> joints_of_skin(const Model& model, int skin) {
  const auto found = std::ranges::find(model.skins, skin, &Skin::skin);
  if (found == model.skins.end()) {
    return Error{"\"" + model.skeleton.name + "\" has no skin " + std::to_string(skin) +
                 ": give the index of one in Model::skins"};
  }
  JointList list;
  for (std::size_t joint = 0; joint < found->bones.size(); ++joint) {
    list.push_back({.bone = found->bones[joint], .post = found->inverse_binds[joint]});
  }
  return list;
}

}  // namespace throng::anim
