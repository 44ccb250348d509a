#include "engine/anim/bake/root_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/bake/body_turn.h"
#include "engine/anim/bake/surface.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

constexpr double least_travel = 0.05;  // metres of a person of 1.8 m

std::vector<int> subtree_sizes(const Skeleton& skeleton) {
  std::vector<int> sizes(skeleton.bones.size(), 1);
  for (std::size_t bone = sizes.size(); bone-- > 0;) {
    const int parent = skeleton.bones[bone].parent;
    if (parent >= 0) sizes[static_cast<std::size_t>(parent)] += sizes[bone];
  }
  return sizes;
}

/// Returns the moving bone with the largest subtree, of more than half of all bones; -1 if there is none.
int topmost_moving_bone(const Skeleton& skeleton, const StateClip& clip, KeyChannel channel) {
  const std::vector<int> sizes = subtree_sizes(skeleton);
  int best = -1;
  int best_size = skeleton.bone_count() / 2;
  for (const StateTrack& track : clip.tracks) {
    const int size = sizes[static_cast<std::size_t>(track.bone)];
    if (track.channel != channel || size <= best_size) continue;
    best = track.bone;
    best_size = size;
  }
  return best;
}

bool is_root(const Skeleton& skeleton, int bone) { return skeleton.parent(bone) < 0; }

bool a_root_steps(const Skeleton& skeleton, const StateClip& clip) {
  return std::ranges::any_of(clip.tracks, [&](const StateTrack& track) {
    return track.channel == KeyChannel::position && track.interpolation == Interpolation::step &&
           is_root(skeleton, track.bone);
  });
}

/// Says whether the nodes above every root keep the shape of what they turn.
bool roots_can_turn(const Skeleton& skeleton) {
  return std::ranges::all_of(skeleton.bones, [](const Bone& bone) {
    const glm::dmat3 shape = glm::transpose(glm::dmat3(bone.prefix)) * glm::dmat3(bone.prefix);
    const double scale = shape[0][0];
    double off = 0.0;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row)
        off = std::max(off, std::abs(shape[column][row] - (column == row ? scale : 0.0)));
    }
    return bone.parent >= 0 || off <= 1e-5 * scale;
  });
}

/// Returns times from 0 to `seconds`, about `step` apart.
std::vector<double> even_times(double seconds, double step) {
  const double count = std::max(std::round(seconds / step), 1.0);
  std::vector<double> times;
  for (double i = 0.0; i <= count; i += 1.0) times.push_back(seconds * i / count);
  return times;
}

BoneTracks& tracks_of(Clip& clip, int bone) {
  const auto place = std::ranges::lower_bound(clip.tracks, bone, {}, &BoneTracks::bone);
  if (place != clip.tracks.end() && place->bone == bone) return *place;
  return *clip.tracks.insert(place, BoneTracks{.bone = bone, .translation = {}, .rotation = {}, .scale = {}});
}

glm::dmat4 matrix_of(const RootMotion& motion) {
  const glm::dmat4 turn = glm::mat4_cast(angle_axis(motion.yaw, glm::dvec3(0.0, 1.0, 0.0)));
  return glm::translate(glm::dmat4(1.0), motion.translation) * turn;
}

glm::dvec3 origin_at(const Skeleton& skeleton, ExactPoses& poses, int bone, Ticks time) {
  std::vector<BoneFrame> frames(skeleton.bones.size());
  compute_frames(skeleton, poses.at(time), frames);
  return frames[static_cast<std::size_t>(bone)].origin;
}

glm::dvec3 travel_of(const Skeleton& skeleton, const StateClip& clip, int bone, double least) {
  const AlignedBytes block = pack_keyframe_stream(clip);
  ExactPoses poses(*reinterpret_cast<const KeyframeStream*>(block.get()));
  glm::dvec3 travel = origin_at(skeleton, poses, bone, clip.duration) - origin_at(skeleton, poses, bone, Ticks{});
  travel.y = 0.0;
  return glm::length(travel) > least ? travel : glm::dvec3(0.0);
}

}  // namespace

RootCurve find_root_motion(const Skeleton& skeleton, const StateClip& clip, double size) {
  const RootCurve none{.duration = clip.duration, .keys = {}};
  if (clip.duration <= Ticks{} || a_root_steps(skeleton, clip)) return none;
  const int moving = topmost_moving_bone(skeleton, clip, KeyChannel::position);
  const int turning = topmost_moving_bone(skeleton, clip, KeyChannel::rotation);
  const glm::dvec3 travel = moving < 0 ? glm::dvec3(0.0) : travel_of(skeleton, clip, moving, least_travel * size);
  const int bone = moving < 0 || (turning >= 0 && turning < moving) ? turning : moving;
  if (bone < 0) return none;
  RootVelocity velocity = steady_root_velocity(skeleton, clip, bone, travel, size);
  if (velocity.yaw != 0.0 && roots_can_turn(skeleton)) return steady_root_curve(clip.duration, velocity);
  return straight_root_curve(clip.duration, {travel.x, velocity.linear.y * to_seconds(clip.duration), travel.z});
}

glm::dvec3 straight_travel(const RootCurve& curve) {
  if (curve.keys.empty() || curve.keys.back().yaw != 0.0) return glm::dvec3(0.0);
  const RootKey& last = curve.keys.back();
  return {last.x, last.y, last.z};
}

Clip without_root_motion(const Skeleton& skeleton, const Clip& clip, const RootCurve& curve, double start,
                         double step) {
  Clip in_place = clip;
  const double seconds = to_seconds(curve.duration);
  const std::vector<double> times = even_times(seconds, step);
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    if (!is_root(skeleton, bone)) continue;
    BoneTracks& tracks = tracks_of(in_place, bone);
    const Bone& root = skeleton.bones[static_cast<std::size_t>(bone)];
    const BoneTracks before = tracks;
    tracks.rotation = {};
    tracks.translation = {};
    for (const double time : times) {
      const FineTicks position = to_ticks(time) * fine_ticks_per_tick;
      const RootMotion back = inverse(displacement(curve, 0, position, false));
      const StateTransform local = sample_bone(root, &before, start + time);
      const glm::dmat4 moved = glm::inverse(root.prefix) * matrix_of(back) * root.prefix;
      const auto key = static_cast<float>(start + time);
      tracks.rotation.times.push_back(key);
      tracks.rotation.values.emplace_back(glm::normalize(glm::quat_cast(glm::dmat3(moved)) * local.rotation));
      tracks.translation.times.push_back(key);
      tracks.translation.values.emplace_back(glm::dvec3(moved * glm::dvec4(local.position, 1.0)));
    }
  }
  return in_place;
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
