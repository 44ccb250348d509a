#include "engine/anim/asset/keyframe_stream_clip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace throng::anim {

namespace {

/// Smaller differences are rounding of a 32-bit file; relative to the largest component or a centimetre.
constexpr double still = 1e-7;
constexpr double least_magnitude = 0.01;

/// Does to a property of a bone what to_state does: linear * value + constant.
struct StateMap {
  std::array<glm::dvec4, 4> columns{};
  glm::dvec4 constant{0.0};

  glm::dvec4 direction(const glm::dvec4& value) const {
    return columns[0] * value.x + columns[1] * value.y + columns[2] * value.z + columns[3] * value.w;
  }
  glm::dvec4 point(const glm::dvec4& value) const { return direction(value) + constant; }
};

glm::dvec4 components_of(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }
glm::dquat quaternion_of(const glm::dvec4& v) { return {v.w, v.x, v.y, v.z}; }
glm::dvec4 unit_axis(int axis) {
  glm::dvec4 unit(0.0);
  unit[axis] = 1.0;
  return unit;
}

StateMap rotation_map(const Skeleton& skeleton, int bone) {
  StateMap map;
  for (int axis = 0; axis < 4; ++axis) {
    const StateTransform local{.rotation = quaternion_of(unit_axis(axis))};
    map.columns[static_cast<std::size_t>(axis)] = components_of(to_state(skeleton, bone, local).rotation);
  }
  return map;
}

StateMap position_map(const Skeleton& skeleton, int bone) {
  const auto position_at = [&](const glm::dvec4& translation) {
    return glm::dvec4(to_state(skeleton, bone, {.position = glm::dvec3(translation)}).position, 0.0);
  };
  StateMap map{.constant = position_at(glm::dvec4(0.0))};
  for (int axis = 0; axis < 3; ++axis) {
    map.columns[static_cast<std::size_t>(axis)] = position_at(unit_axis(axis)) - map.constant;
  }
  return map;
}

StateMap scale_map() { return {.columns = {unit_axis(0), unit_axis(1), unit_axis(2), glm::dvec4(0.0)}}; }

glm::dvec4 widen(const glm::vec3& v) { return {v, 0.0}; }
glm::dvec4 widen(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

/// Reads the file's keys in double, with tangents where the track has them.
template <typename Value>
std::vector<StateKey> read_keys(const Track<Value>& track, double start) {
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  std::vector<StateKey> keys(track.times.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    keys[k].time = key_ticks(static_cast<double>(track.times[k]) - start);
    keys[k].value = widen(track.values[cubic ? 3 * k + 1 : k]);
    if (!cubic) continue;
    keys[k].in_tangent = widen(track.values[3 * k]);
    keys[k].out_tangent = widen(track.values[3 * k + 2]);
  }
  return keys;
}

/// Turns each key to the shorter arc from the key before it; a zero dot product counts as positive (glTF 2.0, C.4). The
/// signs come from the file's own values, which the conversion would round.
void choose_hemispheres(std::vector<StateKey>& keys) {
  bool flipped = false;
  glm::dvec4 previous = keys.front().value;
  for (std::size_t k = 1; k < keys.size(); ++k) {
    const glm::dvec4 own = keys[k].value;
    if (glm::dot(previous, own) < 0.0) flipped = !flipped;
    if (flipped) keys[k].value = -own;
    previous = own;
  }
}

glm::dvec4 normalised(const glm::dvec4& q) {
  const double length = glm::length(q);
  return length > 0.0 ? q / length : unit_axis(3);
}

std::vector<StateKey> read_rotation_keys(const Track<glm::quat>& track, double start) {
  std::vector<StateKey> keys = read_keys(track, start);
  if (track.interpolation == Interpolation::cubic_spline) return keys;
  choose_hemispheres(keys);
  for (StateKey& key : keys) key.value = normalised(key.value);
  return keys;
}

double largest_component(const glm::dvec4& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w)});
}

bool moves(const std::vector<StateKey>& keys, double duration_seconds) {
  if (keys.size() < 2) return false;
  double magnitude = least_magnitude;
  for (const StateKey& key : keys) magnitude = std::max(magnitude, largest_component(key.value));
  return std::ranges::any_of(keys, [&](const StateKey& key) {
    const double tangent = std::max(largest_component(key.in_tangent), largest_component(key.out_tangent));
    const double step = largest_component(key.value - keys.front().value);
    return std::max(step, tangent * duration_seconds) > still * magnitude;
  });
}

void convert(std::vector<StateKey>& keys, const StateMap& map) {
  for (StateKey& key : keys) {
    key.value = map.point(key.value);
    key.in_tangent = map.direction(key.in_tangent);
    key.out_tangent = map.direction(key.out_tangent);
  }
}

/// Adds a moving track to the clip, or the constant value of a property that does not move.
void add_track(StateClip& clip, StateTrack track, const StateMap& map) {
  const bool moving = moves(track.keys, to_seconds(clip.duration));
  convert(track.keys, map);
  StateTransform& constant = clip.constants[static_cast<std::size_t>(track.bone)];
  const glm::dvec4 first = track.keys.front().value;
  switch (track.channel) {
    case KeyChannel::rotation:
      constant.rotation = quaternion_of(normalised(first));
      break;
    case KeyChannel::position:
      constant.position = glm::dvec3(first);
      break;
    case KeyChannel::scale:
      constant.scale = glm::dvec3(first);
      break;
  }
  if (!moving) return;
  clip.tracks.push_back(std::move(track));
}

void add_bone_tracks(StateClip& clip, const Skeleton& skeleton, const BoneTracks& tracks) {
  const int bone = tracks.bone;
  if (!tracks.rotation.empty()) {
    add_track(
        clip,
        {bone, KeyChannel::rotation, tracks.rotation.interpolation, read_rotation_keys(tracks.rotation, clip.start)},
        rotation_map(skeleton, bone));
  }
  if (!tracks.translation.empty()) {
    add_track(clip,
              {bone, KeyChannel::position, tracks.translation.interpolation, read_keys(tracks.translation, clip.start)},
              position_map(skeleton, bone));
  }
  if (!tracks.scale.empty() && !skeleton.rigid) {
    add_track(clip, {bone, KeyChannel::scale, tracks.scale.interpolation, read_keys(tracks.scale, clip.start)},
              scale_map());
  }
}

/// Returns the state of a bone that no track moves.
StateTransform rest_state(const Skeleton& skeleton, int bone) {
  const Transform& rest = skeleton.bones[static_cast<std::size_t>(bone)].rest;
  const glm::dquat rotation = quaternion_of(normalised(widen(rest.rotation)));
  return to_state(skeleton, bone, {rotation, glm::dvec3(rest.translation), glm::dvec3(rest.scale)});
}

/// Returns the position track of `bone`, and makes one of its constant if it has none.
StateTrack& position_track(StateClip& clip, int bone) {
  const auto before = [](const StateTrack& track, const StateTrack& key) {
    return track.bone != key.bone ? track.bone < key.bone : track.channel < key.channel;
  };
  const StateTrack wanted{
      .bone = bone, .channel = KeyChannel::position, .interpolation = Interpolation::linear, .keys = {}};
  auto place = std::lower_bound(clip.tracks.begin(), clip.tracks.end(), wanted, before);
  if (place == clip.tracks.end() || place->bone != bone || place->channel != KeyChannel::position) {
    place = clip.tracks.insert(place, wanted);
    place->keys = {{.value = glm::dvec4(clip.constants[static_cast<std::size_t>(bone)].position, 0.0)}};
  }
  return *place;
}

/// Adds keys at both ends of the clip where the nearest key held, so that the track covers the whole line.
void cover(StateTrack& track, Ticks duration) {
  if (StateKey& first = track.keys.front(); first.time > Ticks{}) {
    first.in_tangent = glm::dvec4(0.0);
    const StateKey held{.time = Ticks{}, .value = first.value};
    track.keys.insert(track.keys.begin(), held);
  }
  if (StateKey& last = track.keys.back(); last.time < duration) {
    last.out_tangent = glm::dvec4(0.0);
    const StateKey held{.time = duration, .value = last.value};
    track.keys.push_back(held);
  }
}

}  // namespace

Ticks key_ticks(double seconds) { return to_ticks(std::min(seconds, longest_clip)); }

StateClip to_state_space(const Skeleton& skeleton, const Clip& clip, double start) {
  StateClip state{.start = start,
                  .duration = key_ticks(clip.duration - start),
                  .components = skeleton.components(),
                  .constants = {},
                  .tracks = {}};
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) state.constants.push_back(rest_state(skeleton, bone));
  for (const BoneTracks& tracks : clip.tracks) add_bone_tracks(state, skeleton, tracks);
  return state;
}

void subtract_drift(StateClip& clip, int bone, const glm::dvec3& drift) {
  assert(clip.duration > Ticks{});
  StateTrack& track = position_track(clip, bone);
  assert(track.interpolation != Interpolation::step);
  cover(track, clip.duration);
  const glm::dvec4 slope(drift / to_seconds(clip.duration), 0.0);
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  for (StateKey& key : track.keys) {
    key.value -= slope * to_seconds(key.time);
    if (!cubic) continue;
    key.in_tangent -= slope;
    key.out_tangent -= slope;
  }
}

}  // namespace throng::anim
