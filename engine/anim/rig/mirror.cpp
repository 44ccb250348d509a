#include "engine/anim/rig/mirror.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

constexpr double likeness = 0.05;  // of the skeleton's extent: an image that is farther off is none

std::size_t slot(int bone) { return static_cast<std::size_t>(bone); }

/// The bind pose of a skeleton, before a mirror that stands across its hips.
class BindMirror {
 public:
  BindMirror(const Skeleton& skeleton, const RigMap& rig) : skeleton_(skeleton) {
    const int hips = std::max(rig.at(BodyRole::hips), 0);
    plane_ = skeleton.references[slot(hips)].origin.x;
    for (const ReferenceFrame& frame : skeleton.references) {
      extent_ = std::max(extent_, glm::distance(frame.origin, skeleton.references[slot(hips)].origin));
    }
  }
  double distance(int bone, int image) const {
    glm::dvec3 there = skeleton_.references[slot(bone)].origin;
    there.x = 2.0 * plane_ - there.x;
    return glm::distance(there, skeleton_.references[slot(image)].origin);
  }
  bool is_image(int bone, int image) const { return distance(bone, image) <= likeness * extent_; }

 private:
  const Skeleton& skeleton_;
  double plane_ = 0.0;
  double extent_ = 0.0;
};

/// Returns the role on the other side; the role itself in the middle.
BodyRole other_side(BodyRole role) {
  constexpr std::size_t left = index_of(BodyRole::left_shoulder), right = index_of(BodyRole::right_shoulder);
  const std::size_t index = index_of(role);
  if (index < left) return role;
  return static_cast<BodyRole>(index < right ? index + (right - left) : index - (right - left));
}

/// Pairs the bones whose part of the body is known. -1: the part is not.
MirrorMap paired_by_role(const Skeleton& skeleton, const RigMap& rig) {
  MirrorMap mirror(skeleton.bones.size(), -1);
  for (std::size_t role = 0; role < body_role_count; ++role) {
    const int bone = rig.bones[role], other = rig.at(other_side(static_cast<BodyRole>(role)));
    if (bone >= 0 && other >= 0) mirror[slot(bone)] = other;
  }
  return mirror;
}

int nearest_partner(const Skeleton& skeleton, const BindMirror& bind, const MirrorMap& mirror, int bone) {
  const int parent = skeleton.bones[slot(bone)].parent;
  const int other_parent = parent < 0 ? -1 : mirror[slot(parent)];
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int other = 0; other < skeleton.bone_count(); ++other) {
    const bool is_taken = std::ranges::find(mirror, other) != mirror.end();
    if (skeleton.bones[slot(other)].parent != other_parent || is_taken) continue;
    const double away = bind.distance(bone, other);
    if (away >= least) continue;
    least = away;
    best = other;
  }
  return best;
}

std::string quoted(const Bone& bone) { return "\"" + bone.name + "\""; }

glm::dquat mirrored(const glm::dquat& q) { return {q.w, q.x, -q.y, -q.z}; }
glm::dvec3 mirrored(const glm::dvec3& v) { return {-v.x, v.y, v.z}; }

/// Brings local transforms of a bone to those of its partner.
class BoneMirror {
 public:
  BoneMirror(const Skeleton& skeleton, int from, int to) : skeleton_(skeleton), from_(from), to_(to) {}

  StateTransform operator()(const StateTransform& local) const {
    StateTransform state = to_state(skeleton_, from_, local);
    state.rotation = mirrored(state.rotation);
    state.position = mirrored(state.position);
    return to_local(skeleton_, to_, state);
  }
  glm::quat rotation(const glm::quat& q) const { return glm::quat((*this)({.rotation = glm::dquat(q)}).rotation); }
  glm::vec3 point(const glm::vec3& p) const { return glm::vec3((*this)({.position = glm::dvec3(p)}).position); }
  glm::vec3 direction(const glm::vec3& v) const { return point(v) - point(glm::vec3(0.0F)); }

 private:
  const Skeleton& skeleton_;
  int from_, to_;
};

void mirror_tracks(BoneTracks& tracks, const BoneMirror& mirror) {
  for (glm::quat& value : tracks.rotation.values) value = mirror.rotation(value);
  const bool cubic = tracks.translation.interpolation == Interpolation::cubic_spline;
  for (std::size_t i = 0; i < tracks.translation.values.size(); ++i) {
    glm::vec3& value = tracks.translation.values[i];
    value = cubic && i % 3 != 1 ? mirror.direction(value) : mirror.point(value);
  }
}

/// Gives a property that nothing moves one key where the rest pose is not its own mirror image.
void keep_rest(BoneTracks& tracks, const StateTransform& image, const Bone& bone, double start) {
  constexpr double alike = 1e-6;
  const auto time = static_cast<float>(start);
  const StateTransform rest = rest_transform(bone);
  if (tracks.rotation.empty() && std::abs(glm::dot(image.rotation, rest.rotation)) < 1.0 - alike) {
    tracks.rotation = {.interpolation = Interpolation::step, .times = {time}, .values = {glm::quat(image.rotation)}};
  }
  if (tracks.translation.empty() && glm::distance(image.position, rest.position) > alike) {
    tracks.translation = {.interpolation = Interpolation::step, .times = {time}, .values = {glm::vec3(image.position)}};
  }
}

std::string with_sides_swapped(const std::string& name) {
  static constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}};
  std::string swapped;
  for (std::size_t i = 0; i < name.size();) {
    const std::string_view rest = std::string_view(name).substr(i);
    std::string_view from = rest.substr(0, 1), to = from;
    for (const auto& [left, right] : words) {
      if (rest.starts_with(left)) from = left, to = right;
      if (rest.starts_with(right)) from = right, to = left;
    }
    swapped += to;
    i += from.size();
  }
  return swapped;
}

}  // namespace

Result<MirrorMap> find_mirror(const Skeleton& skeleton, const RigMap& rig) {
  if (!skeleton.rigid) {
    return Error{"\"" + skeleton.name +
                 "\" cannot be mirrored: its bones shear or scale; bake its scales into its mesh"};
  }
  const BindMirror bind(skeleton, rig);
  MirrorMap mirror = paired_by_role(skeleton, rig);
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    int& other = mirror[slot(bone)];
    if (other < 0) other = nearest_partner(skeleton, bind, mirror, bone);
    if (other < 0 || !bind.is_image(bone, other)) {
      return Error{"bone " + quoted(skeleton.bones[slot(bone)]) +
                   " has no bone on the other side of the body: mirror a skeleton that is alike on both sides"};
    }
  }
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[slot(bone)].parent, other = mirror[slot(bone)];
    const int expected = parent < 0 ? -1 : mirror[slot(parent)];
    if (mirror[slot(other)] == bone && skeleton.bones[slot(other)].parent == expected) continue;
    return Error{"bones " + quoted(skeleton.bones[slot(bone)]) + " and " + quoted(skeleton.bones[slot(other)]) +
                 " do not hang from bones that mirror each other: say which bone is which part of the body"};
  }
  return mirror;
}

Clip mirror_clip(const Skeleton& skeleton, const Clip& clip, const MirrorMap& mirror) {
  Clip result = clip;
  result.tracks.clear();
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int from = mirror[slot(bone)];
    const auto moves = std::ranges::find(clip.tracks, from, &BoneTracks::bone);
    const BoneMirror image(skeleton, from, bone);
    BoneTracks tracks;
    if (moves != clip.tracks.end()) tracks = *moves;
    tracks.bone = bone;
    mirror_tracks(tracks, image);
    keep_rest(tracks, image(rest_transform(skeleton.bones[slot(from)])), skeleton.bones[slot(bone)], clip.start);
    const bool moves_something = !tracks.rotation.empty() || !tracks.translation.empty() || !tracks.scale.empty();
    if (moves_something) result.tracks.push_back(std::move(tracks));
  }
  for (NamedDataKey& key : result.data_keys) key.name = with_sides_swapped(key.name);
  for (NamedCurve& curve : result.curves) curve.name = with_sides_swapped(curve.name);
  return result;
}

}  // namespace throng::anim
