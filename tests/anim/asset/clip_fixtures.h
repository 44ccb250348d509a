#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/model.h"
#include "engine/anim/kernel/keyframe/keyframe_player.h"

namespace throng::anim {

/// Returns a rig on the general path: it has uneven rest scales, and a sheared prefix between two bones.
Model general_model(int bones);

/// Returns a clip in which every bone turns, moves and, on the general path, scales. Every track has its own number of
/// keys at uneven times in `seconds`, none at the clip's ends.
Clip wild_clip(const Skeleton& skeleton, Interpolation interpolation, double seconds, unsigned seed);

/// Returns a model of one bone, bound at the origin.
Model one_bone_model();
/// Returns that model with a rod of 1.8 m on its bone, standing upright.
Model rod_model();
/// Returns a clip of that bone, which has the given tracks.
Clip one_bone_clip(const BoneTracks& tracks, double seconds);

/// Returns keys of a function of time at first + n / rate seconds, n from 0 to `steps`.
Track<glm::vec3> sampled_track(const std::function<glm::vec3(float)>& value, double rate, int steps,
                               double first = 0.0);

/// The bytes of a player. They are on the heap, so that reading past their end shows.
class TestPlayer {
 public:
  explicit TestPlayer(const KeyframeStream& stream);
  /// Returns the whole pose, [packet][component][16].
  std::vector<float> pose_at(Ticks time);
  std::span<const std::byte> interpolations() const { return bytes_; }

 private:
  const KeyframeStream& stream_;
  KeyframeCursor cursor_;
  std::vector<std::byte> bytes_;
};

/// Returns one float of a pose.
float component_of(std::span<const float> pose, int components, int bone, int component);

inline const KeyframeStream& stream_in(const AlignedBytes& block) {
  return *reinterpret_cast<const KeyframeStream*>(block.get());
}

}  // namespace throng::anim
