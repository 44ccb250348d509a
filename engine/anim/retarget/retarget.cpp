#include "engine/anim/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/retarget/body_pose.h"
#include "engine/anim/retarget/retarget_pose.h"

namespace throng::anim {

namespace {

constexpr double longest_step = 1.0 / 30.0;  // seconds between keys: solved poses in between are not linear

/// Adds the times of a track, and for each step of it the instant before.
template <typename Value>
void add_times(const Track<Value>& track, std::vector<float>& times) {
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    const bool steps =
        track.interpolation == Interpolation::step && key > 0 && track.values[key] != track.values[key - 1];
    if (steps) times.push_back(std::nextafter(track.times[key], 0.0F));
    times.push_back(track.times[key]);
  }
}

/// Returns the times at which the clip is posed: its own, and more where they lie further apart than longest_step.
std::vector<float> pose_times(const Clip& clip) {
  std::vector<float> own;
  for (const BoneTracks& tracks : clip.tracks) {
    add_times(tracks.translation, own);
    add_times(tracks.rotation, own);
    add_times(tracks.scale, own);
  }
  std::ranges::sort(own);
  own.erase(std::unique(own.begin(), own.end()), own.end());
  std::vector<float> times;
  for (const float time : own) {
    const auto before = static_cast<double>(times.empty() ? time : times.back());
    const double gap = static_cast<double>(time) - before;
    const int more = static_cast<int>(std::ceil(gap / longest_step)) - 1;
    for (int i = 1; i <= more; ++i) times.push_back(static_cast<float>(before + gap * i / (more + 1)));
    if (times.empty() || time > times.back()) times.push_back(time);
  }
  return times;
}

/// Makes a track of values at `times`; one key is enough where nothing changes.
template <typename Value>
Track<Value> track_of(const std::vector<float>& times, std::vector<Value> values) {
  Track<Value> track{.times = times, .values = std::move(values)};
  const auto is_first = [&](const Value& value) { return value == track.values.front(); };
  if (std::ranges::all_of(track.values, is_first)) {
    track.times.resize(1);
    track.values.resize(1);
  }
  return track;
}

Clip copied(const Clip& clip, const RigMatch& match) {
  std::map<int, int> follower_of;
  for (std::size_t b = 0; b < match.source_of.size(); ++b) follower_of[match.source_of[b]] = static_cast<int>(b);
  Clip result = clip;
  result.tracks.clear();
  for (const BoneTracks& tracks : clip.tracks) {
    const auto follower = follower_of.find(tracks.bone);
    if (follower == follower_of.end()) continue;
    result.tracks.push_back(tracks);
    result.tracks.back().bone = follower->second;
  }
  std::ranges::sort(result.tracks, {}, &BoneTracks::bone);
  return result;
}

/// Poses the clip at every time, and makes tracks of the bones that follow.
Clip posed_again(const Skeleton& from, const Skeleton& to, const RetargetPlan& plan, const Clip& clip) {
  const std::vector<float> times = pose_times(clip);
  std::vector<StateTransform> rest;
  for (const Bone& bone : to.bones) rest.push_back(rest_transform(bone));
  std::vector<std::vector<glm::quat>> rotations(rest.size());
  std::vector<std::vector<glm::vec3>> places(rest.size());
  for (const float time : times) {
    const BodyPose source = pose_of(reference_pose(from, &clip, static_cast<double>(time)).globals);
    std::vector<StateTransform> locals = rest;
    retarget_pose(plan, to, source, locals);
    for (std::size_t bone = 0; bone < rest.size(); ++bone) {
      rotations[bone].emplace_back(locals[bone].rotation);
      places[bone].emplace_back(locals[bone].position);
    }
  }
  Clip result = clip;
  result.tracks.clear();
  for (std::size_t bone = 0; bone < rest.size(); ++bone) {
    if (plan.bones[bone].source < 0) continue;
    BoneTracks tracks{.bone = static_cast<int>(bone), .translation = {}, .rotation = {}, .scale = {}};
    tracks.rotation = track_of(times, std::move(rotations[bone]));
    const glm::vec3 at_rest(rest[bone].position);
    const bool moves = std::ranges::any_of(places[bone], [&](const glm::vec3& place) { return place != at_rest; });
    if (moves) tracks.translation = track_of(times, std::move(places[bone]));
    result.tracks.push_back(std::move(tracks));
  }
  return result;
}

}  // namespace

Retargeter::Retargeter(const Skeleton& from, const Skeleton& to)
    : from_(from), to_(to), match_(match_rigs(from, to)), plan_(plan_retarget(from, to, match_)) {}

RetargetedClip Retargeter::retarget(const Clip& clip) const {
  RetargetedClip result{.clip = {}, .as_it_was = clip.tracks.empty() || keys_fit(from_, to_, match_, clip), .lost = {}};
  result.lost = lost_bones(from_, match_, clip);
  result.clip = result.as_it_was ? copied(clip, match_) : posed_again(from_, to_, plan_, clip);
  result.clip.morph_tracks.clear();  // their morphs belong to another surface
  if (to_.rigid) drop_scales(result.clip);
  return result;
}

}  // namespace throng::anim
