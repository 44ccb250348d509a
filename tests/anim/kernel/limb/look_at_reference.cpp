#include "tests/anim/kernel/limb/look_at_reference.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"
#include "tests/anim/kernel/limb/parent_rotation.h"

namespace throng::anim {
namespace {

constexpr glm::vec3 upright{0.0F, 1.0F, 0.0F};
constexpr float behind = 2.6F;           // radians of yaw from which a target may be looked at over either shoulder
constexpr float nearest_target = 1e-4F;  // metres from the eyes

/// Axes of what carries the looking joints, model space.
struct Body {
  glm::vec3 forward;
  glm::vec3 up;
  glm::vec3 left;
};

struct Gaze {
  float yaw = 0.0F;
  float pitch = 0.0F;
};

Body body_of(const LookAtRig& rig, const ChainMotion& motions) {
  const glm::quat carried = parent_rotation(motions, rig.joints[0]);
  const glm::vec3 forward = carried * rig.forward;
  const glm::vec3 body_up = carried * upright;
  return {.forward = forward, .up = body_up, .left = glm::cross(body_up, forward)};
}

Gaze gaze_along(const Body& body, const glm::vec3& direction) {
  const float ahead = glm::dot(direction, body.forward);
  const float aside = glm::dot(direction, body.left);
  return {.yaw = angle_of(aside, ahead),
          .pitch = angle_of(glm::dot(direction, body.up), std::sqrt(ahead * ahead + aside * aside))};
}

/// The turn from one gaze to another, `share` of the way: back to the front, up or down, and round again. It keeps the
/// head's roll, and its angles are never mixed through the back.
glm::quat turn_of(const Body& body, const Gaze& from, const Gaze& to, float share) {
  const float yaw = from.yaw + (to.yaw - from.yaw) * share;
  const float pitch = (to.pitch - from.pitch) * share;
  return turn_about(body.up, yaw) * turn_about(-body.left, pitch) * turn_about(-body.up, from.yaw);
}

JointMotion carrier_of(const LookAtRig& rig, const ChainMotion& motions) {
  return rig.joints[0] > 0 ? motions[static_cast<std::size_t>(rig.joints[0] - 1)] : JointMotion{};
}

glm::vec3 eyes_of(const LookAtRig& rig, const ChainMotion& motions) {
  const JointMotion& head = motions[static_cast<std::size_t>(rig.chain.tip())];
  return head.position + head.rotation * rig.eyes;
}

/// The chain with every looking joint turned by its share. Poses nothing but `motions`.
ChainMotion turned_chain(const LookAtJob& job, const Body& body, const Gaze& from, const Gaze& to,
                         const ChainMotion& posed) {
  const LookAtRig& rig = *job.rig;
  ChainMotion turned = posed;
  glm::quat turn = JointMotion{}.rotation;
  int next = 0;
  for (int joint = rig.joints[0]; joint < rig.chain.count; ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    if (joint > 0) {
      turned[j].position = turned[j - 1].position + turn * (posed[j].position - posed[j - 1].position);
    }
    if (joint == rig.joints[static_cast<std::size_t>(next)]) {
      turn = turn_of(body, from, to, rig.turned[static_cast<std::size_t>(next)] * job.weight);
      ++next;
    }
    turned[j].rotation = turn * posed[j].rotation;
  }
  return turned;
}

/// Where to look from these eyes, within the limits.
Gaze wanted_gaze(const LookAtJob& job, const Body& body, const glm::vec3& eyes) {
  const LookAtState& state = *job.state;
  const glm::vec3 to_target = job.target - eyes;
  if (glm::length(to_target) < nearest_target) return {.yaw = state.yaw.value, .pitch = state.pitch.value};
  Gaze gaze = gaze_along(body, unit_or(to_target, body.forward));
  const bool other_shoulder = gaze.yaw * state.yaw.value < 0.0F;
  if (std::fabs(gaze.yaw) > behind && other_shoulder) gaze.yaw = -gaze.yaw;
  return {.yaw = std::clamp(gaze.yaw, -job.limits.yaw, job.limits.yaw),
          .pitch = std::clamp(gaze.pitch, -job.limits.pitch_down, job.limits.pitch_up)};
}

void write(const LookAtRig& rig, const PoseView& pose, const ChainMotion& turned) {
  for (int i = 0; i < rig.joint_count; ++i) {
    const int joint = rig.joints[static_cast<std::size_t>(i)];
    const glm::quat local =
        glm::conjugate(parent_rotation(turned, joint)) * turned[static_cast<std::size_t>(joint)].rotation;
    pose.set_rotation(rig.chain.bones[static_cast<std::size_t>(joint)], glm::normalize(local));
  }
}

}  // namespace

float look_at_by_definition(const LookAtJob& job) {
  const LookAtRig& rig = *job.rig;
  LookAtState& state = *job.state;
  if (job.weight <= 0.0F) state = {};
  if (job.weight <= 0.0F || !is_within(rig.chain, job.pose) || !is_place(job.target)) return 0.0F;

  ChainMotion posed;
  pose_chain(rig.chain, job.pose, posed);
  const Body body = body_of(rig, posed);
  const glm::quat head = posed[static_cast<std::size_t>(rig.chain.tip())].rotation;
  const Gaze from = gaze_along(body, head * rig.forward);
  const JointMotion carrier = carrier_of(rig, posed);
  const auto as_carrier_sees = [&carrier](const glm::vec3& place) {
    return glm::conjugate(carrier.rotation) * (place - carrier.position);
  };
  if (!state.started) {
    const glm::vec3 posed_eyes = as_carrier_sees(eyes_of(rig, turned_chain(job, body, from, from, posed)));
    state = {.yaw = {from.yaw, 0.0F}, .pitch = {from.pitch, 0.0F}, .eyes = posed_eyes, .started = true};
  }

  // The eyes move with the turn; seen from where they were left last, the gaze settles on the target exactly.
  const Gaze wanted = wanted_gaze(job, body, carrier.position + carrier.rotation * state.eyes);
  state.yaw = smooth_damp(state.yaw, wanted.yaw, job.limits.smooth_seconds, job.seconds);
  state.pitch = smooth_damp(state.pitch, wanted.pitch, job.limits.smooth_seconds, job.seconds);

  const ChainMotion turned = turned_chain(job, body, from, {.yaw = state.yaw.value, .pitch = state.pitch.value}, posed);
  write(rig, job.pose, turned);
  state.eyes = as_carrier_sees(eyes_of(rig, turned));
  const glm::vec3 facing = turned[static_cast<std::size_t>(rig.chain.tip())].rotation * rig.forward;
  const glm::vec3 to_target = unit_or(job.target - eyes_of(rig, turned), facing);
  return angle_of(glm::length(glm::cross(facing, to_target)), glm::dot(facing, to_target));
}

}  // namespace throng::anim
