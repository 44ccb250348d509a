#include "engine/anim/kernel/ragdoll/ragdoll.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "engine/anim/kernel/ragdoll/ragdoll_substep.h"

namespace throng::anim {
namespace {

constexpr float gravity = 9.81F;  // metres per second squared
constexpr int substeps = 6;
constexpr float steps_a_second = 120.0F;
constexpr float substep_seconds = 1.0F / (steps_a_second * substeps);
static_assert(ragdoll_step_ticks * 120 == ticks_per_second);

constexpr float fastest_body = 30.0F;     // metres a second
constexpr float fastest_turning = 40.0F;  // radians a second: a third of a radian a step
constexpr float air_drag = 0.1F;          // share of a second's movement
constexpr float turning_drag = 0.5F;

constexpr float quiet_speed = 0.06F;         // metres a second
constexpr float quiet_turning = 0.6F;        // radians a second
constexpr std::int32_t steps_to_sleep = 60;  // half a second

/// Shortened to `longest`, however long it is.
glm::vec3 clamped(const glm::vec3& v, float longest) {
  const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0.0F) return v;
  const glm::vec3 scaled = v / largest;
  const float length = glm::length(scaled);
  return largest * length > longest ? scaled * (longest / length) : v;
}

void clamp_speeds(const RagdollRig& rig, RagdollBodyState& body) {
  body.velocity = clamped(body.velocity, fastest_body * rig.metre);
  body.angular_velocity = clamped(body.angular_velocity, fastest_turning);
}

void move_freely(RagdollSubstep& step) {
  for (std::size_t b = 0; b < step.rig.bodies.size(); ++b) {
    RagdollBodyState& body = step.bodies[b];
    step.previous_position[b] = body.position;
    step.previous_rotation[b] = body.rotation;
    step.turned_back[b] = glm::vec3(0.0F);
    body.velocity.y -= gravity * step.rig.metre * step.seconds;
    body.velocity *= 1.0F - air_drag * step.seconds;
    body.angular_velocity *= 1.0F - turning_drag * step.seconds;
    clamp_speeds(step.rig, body);
    body.position += body.velocity * step.seconds;
    turn(body, body.angular_velocity * step.seconds);
  }
}

/// Movement is what positions did, solved constraints and all.
void derive_velocities(RagdollSubstep& step) {
  for (std::size_t b = 0; b < step.rig.bodies.size(); ++b) {
    RagdollBodyState& body = step.bodies[b];
    body.velocity = (body.position - step.previous_position[b]) / step.seconds;
    const glm::quat turned = body.rotation * glm::conjugate(step.previous_rotation[b]);
    const float twice = (turned.w < 0.0F ? -2.0F : 2.0F) / step.seconds;
    body.angular_velocity = twice * glm::vec3(turned.x, turned.y, turned.z);
  }
}

float kinetic_energy(const RagdollRig& rig, const RagdollState& state) {
  float joules = 0.0F;
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    const RagdollBody& body = rig.bodies[b];
    const RagdollBodyState& own = state.bodies[b];
    const float along = glm::dot(own.angular_velocity, own.rotation * body.axis);
    const float across = glm::dot(own.angular_velocity, own.angular_velocity) - along * along;
    joules += 0.5F * (glm::dot(own.velocity, own.velocity) / body.inverse_mass + across / body.inverse_inertia +
                      along * along / body.inverse_axial_inertia);
  }
  return joules;
}

float lifting_energy(const RagdollRig& rig, const RagdollState& from, const RagdollState& to) {
  float joules = 0.0F;
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    joules += gravity * rig.metre * (to.bodies[b].position.y - from.bodies[b].position.y) / rig.bodies[b].inverse_mass;
  }
  return joules;
}

/// Removes the energy that moving positions adds where constraints pull against each other.
void take_back_energy(const RagdollRig& rig, const RagdollState& before, RagdollState& state) {
  const float moving = kinetic_energy(rig, state);
  const float gained = moving + lifting_energy(rig, before, state) - kinetic_energy(rig, before);
  if (gained <= 0.0F || moving <= 0.0F) return;
  const float slower = std::sqrt(std::max(moving - gained, 0.0F) / moving);
  for (RagdollBodyState& body : state.bodies) {
    body.velocity *= slower;
    body.angular_velocity *= slower;
  }
}

/// By where the bodies went, not by their velocities: what rises out of the ground has none.
bool is_quiet(const RagdollRig& rig, const RagdollState& before, const RagdollState& state) {
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    const glm::quat turned = state.bodies[b].rotation * glm::conjugate(before.bodies[b].rotation);
    const float turning = 2.0F * steps_a_second * glm::length(glm::vec3(turned.x, turned.y, turned.z));
    const float speed = steps_a_second * glm::distance(state.bodies[b].position, before.bodies[b].position);
    if (speed > quiet_speed * rig.metre || turning > quiet_turning) return false;
  }
  return true;
}

void fall_asleep_if_quiet(const RagdollRig& rig, const RagdollState& before, RagdollState& state) {
  state.quiet_steps = is_quiet(rig, before, state) ? state.quiet_steps + 1 : 0;
  if (state.quiet_steps < steps_to_sleep) return;
  state.asleep = 1;
  for (RagdollBodyState& body : state.bodies) body.velocity = body.angular_velocity = glm::vec3(0.0F);
}

void step_once(const RagdollRig& rig, std::span<const GroundPlane> ground, RagdollState& state) {
  const RagdollState before = state;
  RagdollSubstep step{.rig = rig,
                      .bodies = state.bodies,
                      .seconds = substep_seconds,
                      .previous_position = {},
                      .previous_rotation = {},
                      .turned_back = {},
                      .touches = {}};
  for (int i = 0; i < substeps; ++i) {
    move_freely(step);
    solve_ragdoll_joints(step);
    solve_ragdoll_contacts(ground, step);
    derive_velocities(step);
    damp_ragdoll_joints(step);
    damp_ragdoll_contacts(ground, step);
  }
  take_back_energy(rig, before, state);
  fall_asleep_if_quiet(rig, before, state);
}

}  // namespace

void ragdoll_step(const RagdollRig& rig, std::span<const GroundPlane> ground, Ticks elapsed, RagdollState& state) {
  assert(elapsed >= Ticks{});
  assert(ground.size() == 1 || ground.size() == rig.bodies.size());
  state.unspent += elapsed;
  std::int64_t steps = state.unspent / ragdoll_step_ticks;
  state.unspent %= ragdoll_step_ticks;
  for (; steps > 0 && state.asleep == 0; --steps) step_once(rig, ground, state);
}

void push_ragdoll(const RagdollRig& rig, int body, const glm::vec3& impulse, const glm::vec3& point,
                  RagdollState& state) {
  assert(body >= 0 && body < static_cast<int>(rig.bodies.size()));
  const RagdollBody& pushed = rig.bodies[static_cast<std::size_t>(body)];
  RagdollBodyState& own = state.bodies[body];
  // No more than what reaches the highest speed from the opposite one: larger ones could overflow.
  const glm::vec3 bounded = clamped(impulse, 2.0F * fastest_body * rig.metre / pushed.inverse_mass);
  kick(pushed, own, clamped(point - own.position, pushed.half_length + pushed.radius), bounded);
  clamp_speeds(rig, own);
  wake_ragdoll(state);
}

void wake_ragdoll(RagdollState& state) {
  state.asleep = 0;
  state.quiet_steps = 0;
}

}  // namespace throng::anim
