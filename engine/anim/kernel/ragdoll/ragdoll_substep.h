#pragma once

#include <span>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/ragdoll/ragdoll.h"

namespace throng::anim {

/// The state of one small step of the solver. It lives on the stack.
struct RagdollSubstep {
  const RagdollRig& rig;
  RagdollBodyState* bodies;  ///< one a body of the rig
  float seconds;
  glm::vec3 previous_position[max_ragdoll_bodies];
  glm::quat previous_rotation[max_ragdoll_bodies];
  glm::vec3 turned_back[max_ragdoll_bodies];  ///< the turn back by limits against the parent, a rotation vector
  bool touches[max_ragdoll_bodies][2];        ///< ground held this end of the capsule in this step
};

/// Moves the joints together and turns them back inside their limits.
void solve_ragdoll_joints(RagdollSubstep& step);
/// Slows the turning of joints by friction.
void damp_ragdoll_joints(RagdollSubstep& step);

/// Moves bodies out of the ground and holds them there by friction.
void solve_ragdoll_contacts(std::span<const GroundPlane> ground, RagdollSubstep& step);
/// Slows bodies that touch the ground, so that they neither bounce nor roll for ever.
void damp_ragdoll_contacts(std::span<const GroundPlane> ground, RagdollSubstep& step);

/// Returns the inverse inertia times a vector, both in model space.
inline glm::vec3 turned_by(const RagdollBody& body, const glm::quat& rotation, const glm::vec3& torque) {
  const glm::vec3 axis = rotation * body.axis;
  return body.inverse_inertia * torque +
         (body.inverse_axial_inertia - body.inverse_inertia) * glm::dot(axis, torque) * axis;
}

/// Turns a body by a small rotation vector.
inline void turn(RagdollBodyState& state, const glm::vec3& by) {
  const glm::quat half(0.0F, 0.5F * by.x, 0.5F * by.y, 0.5F * by.z);
  state.rotation = glm::normalize(state.rotation + half * state.rotation);
}

/// Returns how easily a point at `arm` from the centre moves along a unit direction, in 1 / kg.
inline float mobility(const RagdollBody& body, const RagdollBodyState& state, const glm::vec3& arm,
                      const glm::vec3& direction) {
  const glm::vec3 lever = glm::cross(arm, direction);
  return body.inverse_mass + glm::dot(lever, turned_by(body, state.rotation, lever));
}

/// Moves a body by a position-level impulse (kg m) at a point at `arm` from the centre.
inline void shift(const RagdollBody& body, RagdollBodyState& state, const glm::vec3& arm, const glm::vec3& impulse) {
  state.position += body.inverse_mass * impulse;
  turn(state, turned_by(body, state.rotation, glm::cross(arm, impulse)));
}

/// Pushes a body by an impulse (kg m/s) at a point at `arm` from the centre.
inline void kick(const RagdollBody& body, RagdollBodyState& state, const glm::vec3& arm, const glm::vec3& impulse) {
  state.velocity += body.inverse_mass * impulse;
  state.angular_velocity += turned_by(body, state.rotation, glm::cross(arm, impulse));
}

}  // namespace throng::anim
