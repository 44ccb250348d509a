#include "tests/benchmark/programs/local_poses.h"

#include <cstddef>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr float least_shell = 0.03F;  // metres

/// A place in double: of a bone in model space.
struct ModelPlace {
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 position{0.0};
};

LocalPlace in_space_of(const ModelPlace& parent, const ModelPlace& place) {
  const glm::dquat into_parent = glm::conjugate(parent.rotation);
  return {glm::quat(into_parent * place.rotation), glm::vec3(into_parent * (place.position - parent.position))};
}

/// Frames are motions from the bind pose.
std::vector<LocalPlace> places_of(const anim::Skeleton& skeleton, std::span<const anim::BoneFrame> frames) {
  std::vector<ModelPlace> in_model;
  std::vector<LocalPlace> pose;
  for (std::size_t bone = 0; bone < frames.size(); ++bone) {
    const int parent = skeleton.bones[bone].parent;
    in_model.push_back(
        {glm::normalize(glm::quat_cast(frames[bone].axes) * skeleton.references[bone].rotation), frames[bone].origin});
    pose.push_back(
        in_space_of(parent < 0 ? ModelPlace{} : in_model[static_cast<std::size_t>(parent)], in_model.back()));
  }
  return pose;
}

}  // namespace

LocalBones local_bones(const anim::Model& model) {
  const anim::Skeleton& skeleton = model.skeleton;
  LocalBones bones;
  std::vector<anim::BoneFrame> frames;
  for (const anim::Bone& bone : skeleton.bones) bones.parents.push_back(bone.parent);
  for (const anim::ReferenceFrame& reference : skeleton.references) {
    frames.push_back({.origin = reference.origin});
    bones.inverse_binds.push_back(in_space_of({reference.rotation, reference.origin}, {}));
  }
  bones.bind_pose = places_of(skeleton, frames);
  bones.shells.assign(skeleton.bones.size(), least_shell);
  for (const anim::SurfacePoint& point : anim::make_surface_proxy(model).points) {
    float& shell = bones.shells[static_cast<std::size_t>(point.bone)];
    shell = std::max(shell, static_cast<float>(glm::length(point.offset)));
  }
  return bones;
}

LocalClip::LocalClip(const anim::Skeleton& skeleton, const anim::BakedClip& clip)
    : skeleton_(skeleton),
      stream_(*clip.sampled()),
      error_bound_(static_cast<float>(clip.error_bound - clip.keyframe_error)),
      exact_(*clip.keyframe()),
      frames_(skeleton.bones.size()) {}

std::span<const LocalPlace> LocalClip::pose(int sample) {
  compute_frames(skeleton_, exact_.at(time_of(sample)), frames_);
  pose_ = places_of(skeleton_, frames_);
  return pose_;
}

Status has_local_clips(const anim::Character& character) {
  const auto is_sampled = [](const anim::BakedClip& clip) { return clip.sampled() != nullptr; };
  if (character.skeleton.rigid && std::ranges::all_of(character.clips, is_sampled)) return Done{};
  return Error{"it is not given this model, which has scale or matrices, or a clip that plays from its keys"};
}

}  // namespace throng::app
