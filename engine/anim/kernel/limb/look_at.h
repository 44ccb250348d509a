#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <glm/vec3.hpp>

#include "engine/anim/kernel/lanes/smooth_damp.h"
#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/base/result.h"

namespace throng::anim {

inline constexpr int max_look_joints = 8;

/// A bone that takes part in looking, and its weight in the whole turn.
struct LookBone {
  int bone = -1;
  float weight = 1.0F;  ///< above 0; shares are relative to the sum
};

/// The joints that turn towards the target: spine, neck, head. They are made at load and shared by all characters.
struct LookAtRig {
  JointChain chain;  ///< its tip is the head
  int joint_count = 0;
  std::array<std::int16_t, max_look_joints> joints{};  ///< indices into the chain, ascending; the last is the tip
  std::array<float, max_look_joints> turned{};  ///< share of the turn that this joint and those above it have made,
                                                ///< 0 to 1; the last is 1
  glm::vec3 forward{0.0F, 0.0F, 1.0F};          ///< direction that the head faces in the bind pose, unit, level
  glm::vec3 eyes{0.0F};                         ///< metres from the head joint, bind pose
};
static_assert(std::is_trivially_copyable_v<LookAtRig>);

/// Makes the rig of `bones` from the root side to the head, each below the one before. Errors: no bones or more than
/// max_look_joints, weights that are not above 0, bones out of order, a forward that is not level, and those of
/// make_joint_chain.
Result<LookAtRig> make_look_at_rig(const Skeleton& skeleton, std::span<const LookBone> bones,
                                   const glm::vec3& forward = {0.0F, 0.0F, 1.0F},
                                   const glm::vec3& eyes_from_head = glm::vec3(0.0F));

/// The limits of looking in radians, seen from the first joint's parent. Pitch is from 0 to below pi/2, yaw from 0
/// to below pi.
struct alignas(16) LookAtLimits {
  float yaw = 1.3F;
  float pitch_up = 0.7F;
  float pitch_down = 0.7F;
  float smooth_seconds = 0.15F;  ///< see smooth_damp; 0 turns at once
};

bool is_valid(const LookAtLimits& limits);

/// The direction of look that an entity keeps, in radians. A new entity starts with the pose's.
///
///      0      8       16         28          32
///     [ yaw | pitch | eyes x y z | remaining | started, padding ]
struct alignas(16) LookAtState {
  DampedValue yaw;         ///< to the left is positive
  DampedValue pitch;       ///< up is positive
  glm::vec3 eyes{0.0F};    ///< metres, where the last update left them, seen from the first joint's parent
  float remaining = 0.0F;  ///< from the gaze to the target after the last update (0 to pi); 0 where nothing was turned
  bool started = false;
};
static_assert(offsetof(LookAtState, pitch) == 8 && offsetof(LookAtState, eyes) == 16, "read and written by fours");
static_assert(offsetof(LookAtState, remaining) == 28);
static_assert(std::is_trivially_copyable_v<LookAtState>);

/// Turns the joints so that the head faces the target, or as near to it as the limits allow. The head looks at a target
/// behind over the shoulder that is already turned, and never swings through the front because of it. A level of detail
/// without the head, and a target that is not finite (is_place), leave the pose alone.
struct LookAtJob {
  const LookAtRig* rig = nullptr;
  LookAtState* state = nullptr;
  PoseView pose;
  alignas(16) glm::vec3 target{0.0F};  ///< model space, metres
  float seconds = 0.0F;                ///< since the last frame, not negative
  LookAtLimits limits{};
  float weight = 1.0F;  ///< 0 leaves the pose to the bit and forgets the state; fade it to look away
};
bool is_valid(const LookAtJob& job);
static_assert(offsetof(LookAtJob, seconds) == offsetof(LookAtJob, target) + 12, "read together");
/// Returns whether the jobs are a strip: at most widest_strip, all valid and of one rig.
bool is_valid(std::span<const LookAtJob> jobs);

}  // namespace throng::anim
