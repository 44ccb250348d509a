#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/surface.h"
#include "engine/base/result.h"

namespace throng::app {

/// The place of a bone in the space of its parent. Rigid skeletons need no scale.
struct LocalPlace {
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
  glm::vec3 position{0.0F};
};

/// Describes a rigid skeleton to other libraries, bone by bone.
struct LocalBones {
  std::vector<int> parents;               ///< -1 for a root; all are before their children
  std::vector<LocalPlace> bind_pose;      ///< in the space of the parent
  std::vector<LocalPlace> inverse_binds;  ///< from model space
  std::vector<float>
      shells;  ///< metres from the joint at which errors are measured: the farthest vertex, at least 3 cm
};
LocalBones local_bones(const anim::Model& model);

/// A baked clip of a rigid skeleton as samples for other libraries, exactly posed on the grid on which the rows of our
/// own stream lie. It begins at the clip's first key, and its root motion is left out. The clip has a sampled stream.
class LocalClip {
 public:
  LocalClip(const anim::Skeleton& skeleton, const anim::BakedClip& clip);
  int samples() const { return stream_.step_count + 1; }
  Ticks time_of(int sample) const {
    return std::clamp(stream_.first_row + sample * Ticks{stream_.step_ticks}, Ticks{}, stream_.duration);
  }
  /// Returns the pose of a sample, one place a bone, valid until the next call.
  std::span<const LocalPlace> pose(int sample);
  /// Returns the bound that our own stream keeps to, in metres, on joints and on the farthest vertex of each bone.
  float error_bound() const { return error_bound_; }

 private:
  const anim::Skeleton& skeleton_;
  const anim::SampledStream& stream_;
  float error_bound_;
  anim::ExactPoses exact_;
  std::vector<anim::BoneFrame> frames_;
  std::vector<LocalPlace> pose_;
};

/// Says whether all clips of a character can be sampled so.
Status has_local_clips(const anim::Character& character);

}  // namespace throng::app
