#include <algorithm>
#include <cassert>

#include "engine/anim/asset/keyframe_stream_clip.h"

namespace throng::anim {

namespace {

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
  if (StateKey& first = track.keys.front(); first.time > 0) {
    first.in_tangent = glm::dvec4(0.0);
    const StateKey held{.time = 0, .value = first.value};
    track.keys.insert(track.keys.begin(), held);
  }
  if (StateKey& last = track.keys.back(); last.time < duration) {
    last.out_tangent = glm::dvec4(0.0);
    const StateKey held{.time = duration, .value = last.value};
    track.keys.push_back(held);
  }
}

}  // namespace

void subtract_drift(StateClip& clip, int bone, const glm::dvec3& drift) {
  assert(clip.duration > 0);
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
