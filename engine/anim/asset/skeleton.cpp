#include "engine/anim/asset/skeleton.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/base/pose.h"

namespace throng::anim {

namespace {

const ReferenceFrame& parent_frame(const Skeleton& skeleton, int bone) {
  static const ReferenceFrame model;
  const int parent = skeleton.parent(bone);
  return parent < 0 ? model : skeleton.references[static_cast<std::size_t>(parent)];
}

/// Returns the rotation of a matrix that is a rotation times a uniform scale.
glm::dquat rotation_of_similarity(const glm::dmat4& similarity) {
  const glm::dmat3 linear(similarity);
  return glm::normalize(glm::quat_cast(linear / glm::length(linear[0])));
}

}  // namespace

int palette_count_for_bones(const Skeleton& skeleton, int bone_count) {
  const auto end = std::ranges::lower_bound(skeleton.palette, bone_count, {}, &PaletteEntry::bone);
  return static_cast<int>(end - skeleton.palette.begin());
}

int nearest_kept_bone(const Skeleton& skeleton, int bone, int bone_count) {
  assert(bone_count > 0);
  while (bone >= bone_count) bone = skeleton.parent(bone);
  return bone;
}

bool is_below(const Skeleton& skeleton, int bone, int ancestor) {
  while (bone > ancestor) bone = skeleton.parent(bone);
  return bone == ancestor;
}

int common_ancestor(const Skeleton& skeleton, int a, int b) {
  while (a >= 0 && !is_below(skeleton, b, a)) a = skeleton.parent(a);
  return a;
}

JointPlace joint_place(const Skeleton& skeleton, int bone) {
  const auto entry = std::ranges::find(skeleton.palette, bone, &PaletteEntry::bone);
  if (entry == skeleton.palette.end()) return {};
  const int index = static_cast<int>(entry - skeleton.palette.begin());
  if (skeleton.rigid) return {index, skeleton.references[static_cast<std::size_t>(bone)].origin};
  return {index, glm::dvec3(glm::inverse(entry->post)[3])};
}

StateTransform to_state(const Skeleton& skeleton, int bone, const StateTransform& local) {
  if (!skeleton.rigid) return local;
  const Bone& own = skeleton.bones[static_cast<std::size_t>(bone)];
  const ReferenceFrame& frame = skeleton.references[static_cast<std::size_t>(bone)];
  const ReferenceFrame& parent = parent_frame(skeleton, bone);
  const glm::dvec3 in_parent(own.prefix * glm::dvec4(local.position, 1.0));
  return {.rotation =
              parent.rotation * rotation_of_similarity(own.prefix) * local.rotation * glm::conjugate(frame.rotation),
          .position = parent.origin + parent.rotation * (parent.scale * in_parent) - frame.origin,
          .scale = glm::dvec3(1.0)};
}

StateTransform to_local(const Skeleton& skeleton, int bone, const StateTransform& state) {
  if (!skeleton.rigid) return state;
  const Bone& own = skeleton.bones[static_cast<std::size_t>(bone)];
  const ReferenceFrame& frame = skeleton.references[static_cast<std::size_t>(bone)];
  const ReferenceFrame& parent = parent_frame(skeleton, bone);
  const glm::dvec3 in_model = state.position + frame.origin - parent.origin;
  const glm::dvec3 in_parent = glm::conjugate(parent.rotation) * in_model / parent.scale;
  const glm::dvec3 scale(own.rest.scale);
  if (own.prefix == glm::dmat4(1.0)) {
    return {.rotation = glm::conjugate(parent.rotation) * state.rotation * frame.rotation,
            .position = in_parent,
            .scale = scale};
  }
  const glm::dquat to_parent = glm::conjugate(parent.rotation * rotation_of_similarity(own.prefix));
  return {.rotation = to_parent * state.rotation * frame.rotation,
          .position = glm::dvec3(glm::inverse(own.prefix) * glm::dvec4(in_parent, 1.0)),
          .scale = scale};
}

void store_state(const StateTransform& state, int bone, int components, float* pose) {
  const auto& [rotation, position, scale] = state;
  const double values[general_components] = {rotation.x, rotation.y, rotation.z, rotation.w, position.x,
                                             position.y, position.z, scale.x,    scale.y,    scale.z};
  pose += bone / packet_bones * components * packet_bones + bone % packet_bones;
  for (int component = 0; component < components; ++component) {
    pose[component * packet_bones] = static_cast<float>(values[component]);
  }
}

}  // namespace throng::anim
