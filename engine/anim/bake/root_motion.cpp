#include "engine/anim/bake/root_motion.h"

#include <algorithm>
#include <vector>

#include <glm/mat3x3.hpp>

#include "engine/anim/bake/surface.h"

namespace throng::anim {

namespace {

std::vector<int> subtree_sizes(const Skeleton& skeleton) {
  std::vector<int> sizes(skeleton.bones.size(), 1);
  for (std::size_t bone = sizes.size(); bone-- > 0;) {
    const int parent = skeleton.bones[bone].parent;
    if (parent >= 0) sizes[static_cast<std::size_t>(parent)] += sizes[bone];
  }
  return sizes;
}

/// Returns the moving bone with the largest subtree, of more than half of all bones; -1 if there is none.
int topmost_moving_bone(const Skeleton& skeleton, const StateClip& clip) {
  const std::vector<int> sizes = subtree_sizes(skeleton);
  int best = -1;
  int best_size = skeleton.bone_count() / 2;
  for (const StateTrack& track : clip.tracks) {
    const int size = sizes[static_cast<std::size_t>(track.bone)];
    if (track.channel != KeyChannel::position || size <= best_size) continue;
    best = track.bone;
    best_size = size;
  }
  return best;
}

bool is_root(const Skeleton& skeleton, int bone) { return skeleton.bones[static_cast<std::size_t>(bone)].parent < 0; }

bool a_root_steps(const Skeleton& skeleton, const StateClip& clip) {
  return std::ranges::any_of(clip.tracks, [&](const StateTrack& track) {
    return track.channel == KeyChannel::position && track.interpolation == Interpolation::step &&
           is_root(skeleton, track.bone);
  });
}

glm::dvec3 origin_at(const Skeleton& skeleton, ExactPoses& poses, int bone, Ticks time) {
  std::vector<BoneFrame> frames(skeleton.bones.size());
  compute_frames(skeleton, poses.at(time), frames);
  return frames[static_cast<std::size_t>(bone)].origin;
}

}  // namespace

glm::dvec3 find_root_motion(const Skeleton& skeleton, const StateClip& clip, double least) {
  const int bone = topmost_moving_bone(skeleton, clip);
  if (bone < 0 || a_root_steps(skeleton, clip)) return glm::dvec3(0.0);
  const AlignedBytes block = pack_keyframe_stream(clip);
  ExactPoses poses(*reinterpret_cast<const KeyframeStream*>(block.get()));
  glm::dvec3 travel = origin_at(skeleton, poses, bone, clip.duration) - origin_at(skeleton, poses, bone, Ticks{});
  travel.y = 0.0;
  return glm::length(travel) > least ? travel : glm::dvec3(0.0);
}

glm::dvec3 drift_of_root(const Skeleton& skeleton, int bone, const glm::dvec3& travel) {
  if (skeleton.rigid) return travel;
  return glm::inverse(glm::dmat3(skeleton.bones[static_cast<std::size_t>(bone)].prefix)) * travel;
}

void take_root_motion(const Skeleton& skeleton, StateClip& clip, const glm::dvec3& travel) {
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    if (is_root(skeleton, bone)) subtract_drift(clip, bone, drift_of_root(skeleton, bone, travel));
  }
}

}  // namespace throng::anim
