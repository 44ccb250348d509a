#include <cmath>
#include <cstddef>

#include "engine/anim/kernel/ragdoll/ragdoll_substep.h"

namespace throng::anim {
namespace {

/// A joint outside its limits, because an animation left it there or a fall bent it, goes back by this share and this
/// many radians a second; all at once, it would be thrown back.
constexpr float recovery_rate = 20.0F;
constexpr float limit_recovery_speed = 3.0F;
/// Share of the relative turning that a joint loses, a second.
constexpr float joint_friction = 8.0F;

/// Angle of (cosine, sine) in (-pi, pi], within 2e-5: the library's own differs between machines.
float angle_of(float sine, float cosine) {
  const float x = std::abs(cosine);
  const float y = std::abs(sine);
  const float ratio = std::min(x, y) / std::max(std::max(x, y), 1e-30F);
  const float square = ratio * ratio;
  constexpr float half_turn = 3.14159265F;
  float angle =
      ratio *
      (0.99997726F +
       square * (-0.33262347F +
                 square * (0.19354346F + square * (-0.11643287F + square * (0.05265332F - square * 0.01172120F)))));
  if (y > x) angle = 0.5F * half_turn - angle;
  if (cosine < 0.0F) angle = half_turn - angle;
  return sine < 0.0F ? -angle : angle;
}

/// Where a body points, seen from its joint's neutral axes.
struct JointPose {
  glm::quat axes;       ///< neutral axes -> model space
  glm::quat turn;       ///< from neutral
  glm::vec3 direction;  ///< of the body
};

JointPose joint_pose(const RagdollLimit& limit, const glm::quat& parent, const glm::quat& body) {
  JointPose pose{};
  pose.axes = parent * limit.parent_axes;
  pose.turn = glm::conjugate(pose.axes) * (body * limit.axes);
  pose.direction = pose.turn * glm::vec3(1.0F, 0.0F, 0.0F);
  return pose;
}

/// How far a joint is outside a limit, and the axis (model space) about which it went there.
struct Excess {
  float angle = 0.0F;  ///< 0: inside
  glm::vec3 axis{0.0F};
};

Excess excess(const JointPose& pose, float angle, float limit, const glm::vec3& axis) {
  if (std::abs(angle) <= limit) return {};
  return {std::abs(angle) - limit, pose.axes * (angle < 0.0F ? -axis : axis)};
}

Excess swing_excess(const RagdollLimit& limit, const JointPose& pose) {
  const glm::vec3& to = pose.direction;
  if (limit.hinge) return excess(pose, angle_of(to.y, to.x), limit.swing, {0.0F, 0.0F, 1.0F});
  const float away = std::sqrt(to.y * to.y + to.z * to.z);
  const glm::vec3 axis = away > 1e-6F ? glm::vec3(0.0F, -to.z / away, to.y / away) : glm::vec3(0.0F, 0.0F, 1.0F);
  return excess(pose, angle_of(away, to.x), limit.swing, axis);
}

Excess sideways_excess(const RagdollLimit& limit, const JointPose& pose) {
  if (!limit.hinge) return {};
  const glm::vec3& to = pose.direction;
  const float in_plane = std::sqrt(to.x * to.x + to.y * to.y);
  if (in_plane < 1e-6F) return {};
  return excess(pose, angle_of(to.z, in_plane), limit.sideways, {to.y / in_plane, -to.x / in_plane, 0.0F});
}

Excess twist_excess(const RagdollLimit& limit, const JointPose& pose) {
  const glm::quat& turned = pose.turn;
  const float sign = turned.w < 0.0F ? -1.0F : 1.0F;
  const float angle = 2.0F * angle_of(sign * turned.x, sign * turned.w);
  return excess(pose, angle, limit.twist, pose.direction);
}

class JointSolver {
 public:
  JointSolver(RagdollSubstep& step, std::size_t body)
      : step_(step),
        parent_(static_cast<std::size_t>(step.rig.bodies[body].parent)),
        child_(body),
        limit_(step.rig.bodies[body].limit) {}

  void keep_limits() {
    const JointPose pose = joint_pose(limit_, state(parent_).rotation, state(child_).rotation);
    keep_limit(swing_excess(limit_, pose), swing_excess);
    keep_limit(sideways_excess(limit_, pose), sideways_excess);
    keep_limit(twist_excess(limit_, pose), twist_excess);
  }

  void close() {
    const glm::vec3 parent_arm = state(parent_).rotation * body(child_).joint_in_parent;
    const glm::vec3 arm = state(child_).rotation * body(child_).joint;
    const glm::vec3 gap = (state(parent_).position + parent_arm) - (state(child_).position + arm);
    const glm::vec3 impulse = glm::inverse(pair_mobility(parent_arm, arm)) * gap;
    shift(body(child_), state(child_), arm, impulse);
    shift(body(parent_), state(parent_), parent_arm, -impulse);
  }

  /// Friction, and no swing back from a limit.
  void rub() {
    const glm::vec3 turning = state(child_).angular_velocity - state(parent_).angular_velocity;
    glm::vec3 lost = turning * (joint_friction * step_.seconds);
    const glm::vec3& back = step_.turned_back[child_];
    const float returning = glm::dot(turning, back);
    if (returning > 0.0F) lost += back * ((1.0F - joint_friction * step_.seconds) * returning / glm::dot(back, back));
    const glm::vec3 torque = pair_torque(-lost);
    state(child_).angular_velocity += turned_by(body(child_), state(child_).rotation, torque);
    state(parent_).angular_velocity -= turned_by(body(parent_), state(parent_).rotation, torque);
  }

 private:
  /// How both sides of the joint move apart under an impulse. Whole, not along the gap alone: on long limbs most of the
  /// movement is across the gap.
  glm::mat3 pair_mobility(const glm::vec3& parent_arm, const glm::vec3& arm) const {
    glm::mat3 both(body(parent_).inverse_mass + body(child_).inverse_mass);
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 along(0.0F);
      along[axis] = 1.0F;
      both[axis] +=
          glm::cross(turned_by(body(parent_), state(parent_).rotation, glm::cross(parent_arm, along)), parent_arm);
      both[axis] += glm::cross(turned_by(body(child_), state(child_).rotation, glm::cross(arm, along)), arm);
    }
    return both;
  }

  const RagdollBody& body(std::size_t index) const { return step_.rig.bodies[index]; }
  RagdollBodyState& state(std::size_t index) const { return step_.bodies[index]; }

  /// The torque that turns the child against the parent by this much.
  glm::vec3 pair_torque(const glm::vec3& turning) const {
    const float size = glm::length(turning);
    if (size < 1e-9F) return glm::vec3(0.0F);
    const glm::vec3 axis = turning / size;
    const glm::vec3 both =
        turned_by(body(parent_), state(parent_).rotation, axis) + turned_by(body(child_), state(child_).rotation, axis);
    return turning / glm::dot(axis, both);
  }

  /// A limit stops a joint that leaves it; it does not throw back a joint that a pose left outside.
  void keep_limit(const Excess& now, Excess (*measure)(const RagdollLimit&, const JointPose&)) {
    if (now.angle <= 0.0F) return;
    const JointPose before = joint_pose(limit_, step_.previous_rotation[parent_], step_.previous_rotation[child_]);
    const float allowed =
        measure(limit_, before).angle * (1.0F - recovery_rate * step_.seconds) - limit_recovery_speed * step_.seconds;
    const float back = now.angle - std::max(allowed, 0.0F);
    if (back <= 0.0F) return;
    step_.turned_back[child_] -= back * now.axis;
    const glm::vec3 torque = pair_torque(-back * now.axis);
    turn(state(child_), turned_by(body(child_), state(child_).rotation, torque));
    turn(state(parent_), -turned_by(body(parent_), state(parent_).rotation, torque));
  }

  RagdollSubstep& step_;
  std::size_t parent_;
  std::size_t child_;
  const RagdollLimit& limit_;
};

}  // namespace

void solve_ragdoll_joints(RagdollSubstep& step) {
  const std::size_t count = step.rig.bodies.size();
  const auto solve = [&](std::size_t body) {
    JointSolver joint(step, body);
    joint.keep_limits();
    joint.close();
  };
  // Down and up again: in one direction alone, rounding errors of a star of limbs grow until it flies apart.
  for (std::size_t body = 1; body < count; ++body) solve(body);
  for (std::size_t body = count - 1; body > 0; --body) solve(body);
}

void damp_ragdoll_joints(RagdollSubstep& step) {
  for (std::size_t body = 1; body < step.rig.bodies.size(); ++body) JointSolver(step, body).rub();
}

}  // namespace throng::anim
