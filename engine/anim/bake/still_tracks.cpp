#include "engine/anim/bake/still_tracks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace throng::anim {

namespace {

// Every bone counts as carrying something at least so long: a hand without a vertex of its own may hold a sword.
constexpr double least_reach = 0.1;  // of the height

/// Returns how far a track leads from its first key at most, in its own units. A CUBICSPLINE segment lies inside of its
/// Bezier points, which are its keys and a third of each tangent beyond them.
double farthest_from_first(const StateTrack& track) {
  const glm::dvec4 first = track.keys.front().value;
  double farthest = 0.0;
  for (std::size_t k = 0; k < track.keys.size(); ++k) {
    const StateKey& key = track.keys[k];
    const auto seconds_to = [&](std::size_t other) { return std::abs(to_seconds(track.keys[other].time - key.time)); };
    const glm::dvec4 before = k > 0 ? key.in_tangent * seconds_to(k - 1) / 3.0 : glm::dvec4(0.0);
    const glm::dvec4 after = k + 1 < track.keys.size() ? key.out_tangent * seconds_to(k + 1) / 3.0 : glm::dvec4(0.0);
    for (const glm::dvec4& point : {key.value, key.value - before, key.value + after}) {
      farthest = std::max(farthest, glm::distance(point, first));
    }
  }
  return farthest;
}

/// Returns the pose of the first keys, but with every bone as large as it ever is: motion that a small scale hides
/// may turn when it is large.
StateClip at_its_largest(const StateClip& clip) {
  StateClip large{.duration = Ticks{}, .components = clip.components, .constants = clip.constants, .tracks = {}};
  for (const StateTrack& track : clip.tracks) {
    if (track.channel != KeyChannel::scale) continue;
    glm::dvec3& scale = large.constants[static_cast<std::size_t>(track.bone)].scale;
    for (const StateKey& key : track.keys) scale = glm::max(glm::abs(scale), glm::abs(glm::dvec3(key.value)));
  }
  return large;
}

/// Bounds how far tracks move what their bones carry. Limbs count as stretched out, so that it holds for every pose.
class Levers {
 public:
  Levers(const Skeleton& skeleton, const SurfaceProxy& proxy, const StateClip& clip)
      : skeleton_(skeleton),
        clip_(clip),
        frames_(skeleton.bones.size()),
        reach_(skeleton.bones.size(), least_reach * proxy.height) {
    const AlignedBytes stream = pack_keyframe_stream(at_its_largest(clip));
    ExactPoses poses(*reinterpret_cast<const KeyframeStream*>(stream.get()));
    compute_frames(skeleton, poses.at(Ticks{}), frames_);
    for (const SurfacePoint& point : proxy.points) {
      double& reach = reach_[static_cast<std::size_t>(point.bone)];
      reach = std::max(reach, glm::length(frame(point.bone).axes * point.offset));
    }
    const std::vector<double> travel = travel_of_bones();
    for (int bone = skeleton.bone_count() - 1; bone >= 0; --bone) {
      const int parent = parent_of(bone);
      if (parent < 0) continue;
      double& reach = reach_[static_cast<std::size_t>(parent)];
      const double lever = glm::distance(frame(bone).origin, frame(parent).origin);
      reach = std::max(reach, lever + travel[static_cast<std::size_t>(bone)] + reach_of(bone));
    }
  }

  /// Returns the metres by which a track moves any point, from where its first key puts it.
  double motion(const StateTrack& track) const {
    const double far = farthest_from_first(track);
    switch (track.channel) {
      case KeyChannel::rotation:
        return 2.0 * far / std::max(glm::length(track.keys.front().value), far) * reach_of(track.bone);
      case KeyChannel::position:
        return far * carrying_scale(track.bone);
      case KeyChannel::scale:
        break;
    }
    const glm::dvec3 scale = glm::abs(clip_.constants[static_cast<std::size_t>(track.bone)].scale);
    const double least = std::min({scale.x, scale.y, scale.z});
    return least > far ? far / (least - far) * reach_of(track.bone) : std::numeric_limits<double>::infinity();
  }

  int parent_of(int bone) const { return skeleton_.parent(bone); }

 private:
  const BoneFrame& frame(int bone) const { return frames_[static_cast<std::size_t>(bone)]; }
  double reach_of(int bone) const { return reach_[static_cast<std::size_t>(bone)]; }

  /// Metres of model space for one of the bone's state positions.
  double carrying_scale(int bone) const {
    if (skeleton_.rigid) return 1.0;
    const int parent = parent_of(bone);
    const glm::dmat3 axes = (parent < 0 ? glm::dmat3(1.0) : frame(parent).axes) *
                            glm::dmat3(skeleton_.bones[static_cast<std::size_t>(bone)].prefix);
    return std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) + glm::dot(axes[2], axes[2]));
  }

  /// Returns how far each bone moves from where its first key puts it.
  std::vector<double> travel_of_bones() const {
    std::vector<double> travel(skeleton_.bones.size(), 0.0);
    for (const StateTrack& track : clip_.tracks) {
      if (track.channel != KeyChannel::position) continue;
      travel[static_cast<std::size_t>(track.bone)] = farthest_from_first(track) * carrying_scale(track.bone);
    }
    return travel;
  }

  const Skeleton& skeleton_;
  const StateClip& clip_;
  std::vector<BoneFrame> frames_;
  std::vector<double> reach_;  // metres from each bone's origin to the farthest point that it carries
};

/// Adds up what held tracks move, along each chain of bones.
class HeldMotion {
 public:
  explicit HeldMotion(const Levers& levers, std::size_t bones) : levers_(levers), own_(bones, 0.0) {}

  void add(int bone, double metres) { own_[static_cast<std::size_t>(bone)] += metres; }
  double largest() const {
    std::vector<double> sums = own_;
    for (std::size_t bone = 0; bone < sums.size(); ++bone) {
      const int parent = levers_.parent_of(static_cast<int>(bone));
      if (parent >= 0) sums[bone] += sums[static_cast<std::size_t>(parent)];
    }
    return *std::ranges::max_element(sums);
  }

 private:
  const Levers& levers_;
  std::vector<double> own_;
};

}  // namespace

double hold_still_tracks(const Skeleton& skeleton, const SurfaceProxy& proxy, double most, StateClip& clip) {
  const Levers levers(skeleton, proxy, clip);
  std::vector<double> motions;
  motions.reserve(clip.tracks.size());
  for (const StateTrack& track : clip.tracks) {
    const double motion = levers.motion(track);
    motions.push_back(std::isnan(motion) ? std::numeric_limits<double>::infinity() : motion);  // scales may overflow
  }
  std::vector<std::size_t> by_motion(motions.size());
  std::iota(by_motion.begin(), by_motion.end(), std::size_t{0});
  std::ranges::stable_sort(by_motion, {}, [&](std::size_t track) { return motions[track]; });

  HeldMotion held(levers, skeleton.bones.size());
  double moved = 0.0;
  for (const std::size_t track : by_motion) {
    if (!(motions[track] <= most)) break;
    held.add(clip.tracks[track].bone, motions[track]);
    const double together = held.largest();
    if (together > most) break;
    moved = together;
    clip.tracks[track].keys.clear();
  }
  std::erase_if(clip.tracks, [](const StateTrack& track) { return track.keys.empty(); });
  return moved;
}

double largest_step(const Skeleton& skeleton, const SurfaceProxy& proxy, const StateClip& clip) {
  const Levers levers(skeleton, proxy, clip);
  double largest = 0.0;
  for (const StateTrack& track : clip.tracks) {
    if (track.interpolation == Interpolation::step) largest = std::max(largest, levers.motion(track));
  }
  return largest;
}

}  // namespace throng::anim
