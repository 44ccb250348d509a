#include "engine/anim/asset/still_pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {

namespace {

/// Returns the place of each bone in the bind pose; bones that no skin uses have none.
std::vector<std::optional<glm::dmat4>> bind_globals(const Skeleton& skeleton) {
  std::vector<std::optional<glm::dmat4>> globals(skeleton.bones.size());
  for (const PaletteEntry& entry : skeleton.palette) {
    auto& global = globals[static_cast<std::size_t>(entry.bone)];
    const bool invertible = std::abs(glm::determinant(entry.post)) > 0.0;
    if (!global && invertible) global = glm::inverse(entry.post);
  }
  return globals;
}

StateTransform decomposed(const glm::dmat4& matrix) {
  const glm::dvec3 scale(glm::length(matrix[0]), glm::length(matrix[1]), glm::length(matrix[2]));
  glm::dmat3 rotation(matrix);
  for (int axis = 0; axis < 3; ++axis) rotation[axis] /= scale[axis];
  return {.rotation = glm::normalize(glm::quat_cast(rotation)), .position = glm::dvec3(matrix[3]), .scale = scale};
}

StateTransform still_transform(const Skeleton& skeleton, int index,
                               const std::vector<std::optional<glm::dmat4>>& globals) {
  if (skeleton.rigid) return {};
  const Bone& bone = skeleton.bones[static_cast<std::size_t>(index)];
  const auto& own = globals[static_cast<std::size_t>(index)];
  if (bone.parent < 0 || !own || !globals[static_cast<std::size_t>(bone.parent)]) return rest_transform(bone);
  const glm::dmat4 local = glm::inverse(*globals[static_cast<std::size_t>(bone.parent)] * bone.prefix) * *own;
  return std::abs(glm::determinant(local)) > 0.0 ? decomposed(local) : rest_transform(bone);
}

}  // namespace

std::vector<float> still_pose(const Skeleton& skeleton) {
  const int components = skeleton.components();
  std::vector<float> pose(pose_bytes(skeleton.bone_count(), components) / sizeof(float));
  const auto globals = bind_globals(skeleton);
  for (int lane = 0; lane < packets_for(skeleton.bone_count()) * packet_bones; ++lane) {
    const StateTransform state =
        lane < skeleton.bone_count() ? still_transform(skeleton, lane, globals) : StateTransform{};
    const double values[] = {state.rotation.x, state.rotation.y, state.rotation.z, state.rotation.w, state.position.x,
                             state.position.y, state.position.z, state.scale.x,    state.scale.y,    state.scale.z};
    for (int component = 0; component < components; ++component) {
      const int place = (lane / packet_bones * components + component) * packet_bones + lane % packet_bones;
      pose[static_cast<std::size_t>(place)] = static_cast<float>(values[component]);
    }
  }
  return pose;
}

}  // namespace throng::anim
