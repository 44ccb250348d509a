#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/kernel/keyframe/keyframe_player.h"

namespace throng::anim {

/// A rig on the general path: uneven rest scales, and a sheared prefix between two bones.
Model general_model(int bones);

/// Every bone turns, moves and, on the general path, scales; every track has its own number of keys at uneven times in
/// `seconds`, none at the clip's ends.
Clip wild_clip(const Skeleton& skeleton, Interpolation interpolation, double seconds, unsigned seed);

/// One bone, bound at the origin, that only the given tracks move.
Model one_bone_model();
Clip one_bone_clip(const BoneTracks& tracks, double seconds);

/// Keys of a function of time at first + n / rate seconds, n from 0 to `steps`.
Track<glm::vec3> sampled_track(const std::function<glm::vec3(float)>& value, double rate, int steps,
                               double first = 0.0);

/// A player's bytes, on the heap, so that reading past their end shows.
class TestPlayer {
 public:
  explicit TestPlayer(const KeyframeStream& stream);
  /// The whole pose, [packet][component][16].
  std::vector<float> pose_at(Ticks time);
  std::span<const std::byte> interpolations() const { return bytes_; }

 private:
  const KeyframeStream& stream_;
  KeyframeCursor cursor_;
  std::vector<std::byte> bytes_;
};

/// One float of a pose.
float component_of(std::span<const float> pose, int components, int bone, int component);

inline const KeyframeStream& stream_in(const AlignedBytes& block) {
  return *reinterpret_cast<const KeyframeStream*>(block.get());
}

}  // namespace throng::anim
