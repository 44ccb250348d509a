#pragma once

#include "throng/ids.h"
#include "throng/math.h"
#include "throng/standard.h"
#include "throng/ticks.h"

/// Settings of post processes, which change an agent's final pose. They work in the order in which they are added. A
/// call reads strings and spans while it lasts.
namespace throng {

/// Turns spine, neck and head towards a place, within limits. It looks nowhere until Processes::look_at is called.
struct LookAt {
  float yaw = 1.3F;  ///< radians to either side
  float pitch_up = 0.7F;
  float pitch_down = 0.7F;
  float smooth_seconds = 0.15F;  ///< 0 turns at once
};

enum class Limb : unsigned char { left_arm, right_arm, left_leg, right_leg };

/// Lets a hand or a foot reach for a place. Its weight is 0 until it is set.
struct Reach {
  Limb limb = Limb::right_arm;
  float softness = 0.005F;  ///< share of the limb's length over which it becomes straight
  Vec3 pole{};              ///< where the elbow or knee points; 0: where the pose has it
};

/// Lets any chain of bones, such as a tail, reach for a place. Its weight is 0 until it is set.
struct ChainReach {
  std::string_view first{};  ///< the name of the bone that stays
  std::string_view last{};   ///< the name of the bone that reaches
  int iterations = 16;
  float tolerance = 0.001F;  ///< metres
};

/// Lets feet stand on the ground; see Processes::set_placement and set_ground. Until the host tells it otherwise, the
/// ground is flat at height 0. Leg 0 is the left one, leg 1 the right one.
struct FootPlacement {
  float max_drop = 0.4F;       ///< metres that the pelvis may be lowered
  float farthest_lock = 0.4F;  ///< metres from its animation at which a planted foot is let go; 0: none is held
};

/// Adds noise to all joints, so that no agent stands like a statue.
struct Noise {
  float frequency = 0.5F;   ///< Hz
  float amplitude = 0.02F;  ///< radians
  unsigned seed = 0;
  MaskId mask{};
};

/// The movement of a chain of bones, such as a plait or a strip of a skirt.
struct SpringChain {
  std::string_view first{};
  std::string_view last{};
  float stiffness = 80.0F;          ///< per second squared: pulls a bone back to its pose
  float damping = 6.0F;             ///< per second: slows a bone relative to the joint that carries it
  float drag = 1.0F;                ///< per second: slows it relative to the air
  Vec3 gravity{0.0F, -3.0F, 0.0F};  ///< metres per second squared, world: beyond the pose's
  float radius = 0.02F;             ///< metres that the end of each bone keeps from colliders
  float tip = 0.0F;                 ///< metres that the last bone reaches beyond its joint
};

/// A capsule of the body that chains stay outside of.
struct SpringCollider {
  std::string_view bone{};
  Vec3 from{};  ///< metres from the bone's joint, bind pose
  Vec3 to{};
  float radius = 0.1F;
};

/// Lets hair, skirts and tails follow the body on springs.
struct Springs {
  std::span<const SpringChain> chains{};
  std::span<const SpringCollider> colliders{};
};

/// Lets an agent fall when it is pushed, and come back when it is told to. It falls on the ground at height 0 of its
/// model space, and moves in updates alone: while the agent is not posed, Processes::is_down stays as it is.
struct Ragdoll {
  Ticks fade = ticks_per_second / 10;  ///< from the animation to the rag-doll
};

/// Tells where a thing on a bone is: a sword in a hand, a camera on a head.
struct Socket {
  int bone = 0;
  Place offset{};  ///< from the bone's joint, in its own frame
};

/// The pose of one agent, as a step of a host's own sees it. Rotations and positions of rigid characters are relative
/// to the bind pose, in the axes of model space: all 0 is the bind pose. On characters that scale they are local.
class StepPose {
 public:
  StepPose(const void* view, int bones) : view_(view), bones_(bones) {}

  /// Counts the bones of this update: a coarser level has fewer.
  int bone_count() const { return bones_; }
  Quat rotation(int bone) const;
  /// Sets a unit quaternion. A number that is far from one, or NaN, is a misuse, and the bone stays as it was.
  void set_rotation(int bone, const Quat& rotation) const;
  Vec3 position(int bone) const;
  /// Sets metres. NaN and more than a million kilometres are a misuse, and the bone stays as it was.
  void set_position(int bone, const Vec3& position) const;

 private:
  const void* view_;
  int bones_;
};

/// One call of a step. It runs on a PU, beside others: it reads `shared`, changes `memory` and the pose, and neither
/// allocates nor locks.
struct StepJob {
  std::byte* memory;   ///< StepKind::memory_bytes of this agent, 0 at first; it may move between updates
  const void* shared;  ///< StepKind::shared
  Ticks delta;         ///< the time since its last update
  StepPose pose;       ///< of the channels and processes before it
};

/// A step of a host's own (paper 2.2.6). It is added to a crowd once, before agents have it.
struct StepKind {
  const char* name = "";         ///< lives as long as the crowd
  std::size_t memory_bytes = 0;  ///< of each agent: plain bytes without pointers, at most 4,096
  void (*run)(const StepJob& job) = nullptr;
  const void* shared = nullptr;  ///< read-only; lives as long as the crowd
};

/// Names a kind of step of a character of a crowd.
struct StepId {
  CharacterId character{};
  std::uint32_t number = no_number;
};

}  // namespace throng
