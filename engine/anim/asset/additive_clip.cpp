#include "engine/anim/asset/additive_clip.h"

#include <algorithm>
#include <cstddef>

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

const BoneTracks* tracks_of(const Clip& clip, int bone) {
  const auto found = std::ranges::lower_bound(clip.tracks, bone, {}, &BoneTracks::bone);
  return found != clip.tracks.end() && found->bone == bone ? &*found : nullptr;
}

/// Gives a property that the clip leaves at rest one key there.
template <typename Value>
Track<Value> or_rest(const Track<Value>& track, const Value& rest, double start) {
  if (!track.empty()) return track;
  return {.interpolation = Interpolation::step, .times = {static_cast<float>(start)}, .values = {rest}};
}

/// Says whether a value of a track is a tangent, to which nothing is added.
template <typename Value>
bool is_tangent(const Track<Value>& track, std::size_t value) {
  return track.interpolation == Interpolation::cubic_spline && value % 3 != 1;
}

void subtract(Track<glm::quat>& track, const glm::dquat& rest, const glm::dquat& reference) {
  const glm::dquat before = rest * glm::conjugate(reference);
  for (glm::quat& value : track.values) value = glm::quat(before * glm::dquat(value));
}

void subtract(Track<glm::vec3>& track, const glm::dvec3& rest, const glm::dvec3& reference) {
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    if (!is_tangent(track, i)) track.values[i] = glm::vec3(glm::dvec3(track.values[i]) + (rest - reference));
  }
}

// A bone that the reference shrinks to nothing keeps its rest scale, as in SubtractJob.
void divide(Track<glm::vec3>& track, const glm::dvec3& rest, const glm::dvec3& reference) {
  for (std::size_t i = 0; i < track.values.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = static_cast<double>(track.values[i][axis]);
      const double shrunk = is_tangent(track, i) ? 0.0 : rest[axis];
      track.values[i][axis] =
          static_cast<float>(reference[axis] == 0.0 ? shrunk : rest[axis] / reference[axis] * value);
    }
  }
}

}  // namespace

Clip make_additive(const Skeleton& skeleton, const Clip& clip, const Clip& reference, double seconds) {
  Clip additive = clip;
  additive.tracks.clear();
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const BoneTracks* const own = tracks_of(clip, bone);
    const BoneTracks* const other = tracks_of(reference, bone);
    if (own == nullptr && other == nullptr) continue;
    const Bone& of = skeleton.bones[static_cast<std::size_t>(bone)];
    const StateTransform rest = rest_transform(of);
    const StateTransform from = sample_bone(of, other, seconds);
    const BoneTracks none;
    const BoneTracks& moves = own == nullptr ? none : *own;
    BoneTracks& tracks = additive.tracks.emplace_back();
    tracks.bone = bone;
    tracks.rotation = or_rest(moves.rotation, of.rest.rotation, clip.start);
    tracks.translation = or_rest(moves.translation, of.rest.translation, clip.start);
    tracks.scale = or_rest(moves.scale, of.rest.scale, clip.start);
    subtract(tracks.rotation, rest.rotation, from.rotation);
    subtract(tracks.translation, rest.position, from.position);
    divide(tracks.scale, rest.scale, from.scale);
  }
  return additive;
}

}  // namespace throng::anim
