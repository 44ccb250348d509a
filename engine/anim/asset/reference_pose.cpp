#include "engine/anim/asset/reference_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/anim/base/elementary.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {

namespace {

/// The keys around a time. If `from` equals `to` it holds; else the value lies `fraction` of the way to `to`.
struct Span {
  std::size_t from = 0;
  std::size_t to = 0;
  double fraction = 0.0;
  double seconds = 0.0;
};

Span find_span(const std::vector<float>& times, double seconds) {
  const auto after = std::ranges::upper_bound(times, seconds, {}, [](float time) { return static_cast<double>(time); });
  if (after == times.begin()) return {};
  const auto from = static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.end()) return {.from = from, .to = from};
  const auto start = static_cast<double>(times[from]);
  const double length = static_cast<double>(*after) - start;
  return {.from = from, .to = from + 1, .fraction = (seconds - start) / length, .seconds = length};
}

glm::dvec4 wide(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }
glm::dvec3 wide(const glm::vec3& v) { return {v}; }

glm::dquat unit(const glm::dvec4& q) {
  const double length = glm::length(q);
  return length > 0.0 ? glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length)
                      : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

template <typename Value>
auto key(const Track<Value>& track, std::size_t index) {
  return wide(track.values[track.interpolation == Interpolation::cubic_spline ? index * 3 + 1 : index]);
}

/// Interpolates as appendix C.5 says: tangents are multiplied by the length of the span.
template <typename Value>
auto hermite(const Track<Value>& track, const Span& span) {
  const double u = span.fraction;
  const double u2 = u * u;
  const double u3 = u2 * u;
  const auto out_tangent = wide(track.values[span.from * 3 + 2]);
  const auto in_tangent = wide(track.values[span.to * 3]);
  return (2.0 * u3 - 3.0 * u2 + 1.0) * key(track, span.from) + span.seconds * (u3 - 2.0 * u2 + u) * out_tangent +
         (-2.0 * u3 + 3.0 * u2) * key(track, span.to) + span.seconds * (u3 - u2) * in_tangent;
}

/// Interpolates as appendix C.4 says; a zero dot product counts as positive.
glm::dquat shorter_slerp(const glm::dquat& from, glm::dquat to, double u) {
  double cosine = glm::dot(from, to);
  if (cosine < 0.0) {
    to = -to;
    cosine = -cosine;
  }
  const double angle = arc_cosine(std::min(1.0, cosine));
  if (angle < 1e-9) return glm::normalize(from * (1.0 - u) + to * u);
  return glm::normalize((from * sine((1.0 - u) * angle) + to * sine(u * angle)) / sine(angle));
}

template <typename Value>
bool holds(const Track<Value>& track, const Span& span) {
  return span.from == span.to || track.interpolation == Interpolation::step;
}

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

glm::dvec3 sample_track(const Track<glm::vec3>& track, double seconds) {
  assert(!track.empty());
  const Span span = find_span(track.times, seconds);
  if (holds(track, span)) return key(track, span.from);
  if (track.interpolation == Interpolation::cubic_spline) return hermite(track, span);
  return glm::mix(key(track, span.from), key(track, span.to), span.fraction);
}

glm::dquat sample_track(const Track<glm::quat>& track, double seconds) {
  assert(!track.empty());
  const Span span = find_span(track.times, seconds);
  if (holds(track, span)) return unit(key(track, span.from));
  if (track.interpolation == Interpolation::cubic_spline) return unit(hermite(track, span));
  return shorter_slerp(unit(key(track, span.from)), unit(key(track, span.to)), span.fraction);
}

StateTransform rest_transform(const Bone& bone) {
  return {.rotation = glm::normalize(glm::dquat(bone.rest.rotation)),
          .position = bone.rest.translation,
          .scale = bone.rest.scale};
}

StateTransform sample_bone(const Bone& bone, const BoneTracks* tracks, double seconds) {
  StateTransform local = rest_transform(bone);
  if (tracks == nullptr) return local;
  if (!tracks->translation.empty()) local.position = sample_track(tracks->translation, seconds);
  if (!tracks->rotation.empty()) local.rotation = sample_track(tracks->rotation, seconds);
  if (!tracks->scale.empty()) local.scale = sample_track(tracks->scale, seconds);
  return local;
}

glm::dmat4 compose(const StateTransform& local) {
  glm::dmat4 matrix = glm::mat4_cast(local.rotation);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= local.scale[axis];
  matrix[3] = glm::dvec4(local.position, 1.0);
  return matrix;
}

ReferencePose pose_from_locals(const Skeleton& skeleton, std::vector<StateTransform> locals) {
  assert(locals.size() == skeleton.bones.size());
  ReferencePose pose{.locals = std::move(locals), .globals = {}, .palette = {}};
  pose.globals.reserve(pose.locals.size());
  for (std::size_t b = 0; b < pose.locals.size(); ++b) {
    const Bone& bone = skeleton.bones[b];
    const glm::dmat4 in_parent = bone.prefix * compose(pose.locals[b]);
    pose.globals.push_back(bone.parent < 0 ? in_parent
                                           : pose.globals[static_cast<std::size_t>(bone.parent)] * in_parent);
  }
  pose.palette.reserve(skeleton.palette.size());
  for (const PaletteEntry& entry : skeleton.palette) {
    const auto bone = static_cast<std::size_t>(entry.bone);
    if (!skeleton.rigid) {
      pose.palette.push_back(pose.globals[bone] * entry.post);
      continue;
    }
    const ReferenceFrame& frame = skeleton.references[bone];
    const glm::dmat4 from_bind =
        glm::mat4_cast(glm::conjugate(frame.rotation)) * glm::translate(glm::dmat4(1.0), -frame.origin);
    pose.palette.push_back(glm::scale(pose.globals[bone], glm::dvec3(1.0 / frame.scale)) * from_bind);
  }
  return pose;
}

ReferencePose reference_pose(const Skeleton& skeleton, const Clip* clip, double seconds) {
  std::vector<StateTransform> locals;
  locals.reserve(skeleton.bones.size());
  for (const Bone& bone : skeleton.bones) locals.push_back(rest_transform(bone));
  if (clip != nullptr) {
    for (const BoneTracks& tracks : clip->tracks) {
      const auto bone = static_cast<std::size_t>(tracks.bone);
      locals[bone] = sample_bone(skeleton.bones[bone], &tracks, seconds);
    }
  }
  return pose_from_locals(skeleton, std::move(locals));
}

std::vector<float> still_pose(const Skeleton& skeleton) {
  const int components = skeleton.components();
  std::vector<float> pose(pose_bytes(skeleton.bone_count(), components) / sizeof(float));
  const auto globals = bind_globals(skeleton);
  for (int bone = 0; bone < packets_for(skeleton.bone_count()) * packet_bones; ++bone) {
    const bool exists = bone < skeleton.bone_count();
    store_state(exists ? still_transform(skeleton, bone, globals) : StateTransform{}, bone, components, pose.data());
  }
  return pose;
}

}  // namespace throng::anim
