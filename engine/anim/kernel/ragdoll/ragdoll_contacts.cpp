#include <cstddef>

#include "engine/anim/kernel/ragdoll/ragdoll_substep.h"

namespace throng::anim {
namespace {

/// Cloth on ground.
constexpr float ground_friction = 0.7F;
/// A body that starts below the ground comes out this fast, so that it is not thrown: metres a second.
constexpr float ground_recovery_speed = 1.0F;
/// Share of its turning that a body on the ground loses, a second: flesh does not roll as a capsule does.
constexpr float rolling_friction = 5.0F;

const GroundPlane& ground_below(std::span<const GroundPlane> ground, std::size_t body) {
  return ground.size() == 1 ? ground[0] : ground[body];
}

/// From the centre to the lowest point of one of the capsule's ends.
glm::vec3 lowest_point(const RagdollBody& body, const glm::quat& rotation, int end, const glm::vec3& normal) {
  const float along = end == 0 ? -body.half_length : body.half_length;
  return rotation * (body.axis * along) - normal * body.radius;
}

class Contact {
 public:
  Contact(const GroundPlane& ground, RagdollSubstep& step, std::size_t body, int end)
      : ground_(ground),
        step_(step),
        index_(body),
        end_(end),
        body_(step.rig.bodies[body]),
        state_(step.bodies[body]) {}

  /// True if the ground held it.
  bool solve() {
    glm::vec3 arm = lowest_point(body_, state_.rotation, end_, ground_.normal);
    const float depth = depth_of(state_.position + arm);
    if (depth <= 0.0F) return false;
    const glm::vec3 in_body = glm::conjugate(state_.rotation) * arm;
    const glm::vec3 before = step_.previous_position[index_] + step_.previous_rotation[index_] * in_body;
    const float allowed = depth_of(before) - ground_recovery_speed * step_.rig.metre * step_.seconds;
    const float rise = depth - std::max(allowed, 0.0F);
    if (rise <= 0.0F) return false;
    const float pressure = rise / mobility(body_, state_, arm, ground_.normal);
    shift(body_, state_, arm, pressure * ground_.normal);
    arm = state_.rotation * in_body;
    hold(arm, state_.position + arm - before, pressure);
    return true;
  }

  void damp() {
    const glm::vec3 arm = lowest_point(body_, state_.rotation, end_, ground_.normal);
    const float rising = glm::dot(ground_.normal, state_.velocity + glm::cross(state_.angular_velocity, arm));
    if (rising > 0.0F) {
      kick(body_, state_, arm, -rising / mobility(body_, state_, arm, ground_.normal) * ground_.normal);
    }
    state_.angular_velocity *= 1.0F - rolling_friction * step_.seconds;
  }

 private:
  float depth_of(const glm::vec3& point) const { return ground_.height - glm::dot(ground_.normal, point); }

  /// Moves a point back by the distance that it slid, as far as ground_friction allows.
  void hold(const glm::vec3& arm, const glm::vec3& movement, float pressure) {
    const glm::vec3 slide = movement - ground_.normal * glm::dot(ground_.normal, movement);
    const float length = glm::length(slide);
    if (length < 1e-9F) return;
    const glm::vec3 direction = slide / length;
    const float needed = length / mobility(body_, state_, arm, direction);
    shift(body_, state_, arm, -std::min(needed, ground_friction * pressure) * direction);
  }

  const GroundPlane& ground_;
  RagdollSubstep& step_;
  std::size_t index_;
  int end_;
  const RagdollBody& body_;
  RagdollBodyState& state_;
};

}  // namespace

void solve_ragdoll_contacts(std::span<const GroundPlane> ground, RagdollSubstep& step) {
  for (std::size_t body = 0; body < step.rig.bodies.size(); ++body) {
    for (const int end : {0, 1}) {
      step.touches[body][end] = Contact(ground_below(ground, body), step, body, end).solve();
    }
  }
}

void damp_ragdoll_contacts(std::span<const GroundPlane> ground, RagdollSubstep& step) {
  for (std::size_t body = 0; body < step.rig.bodies.size(); ++body) {
    for (const int end : {0, 1}) {
      if (step.touches[body][end]) Contact(ground_below(ground, body), step, body, end).damp();
    }
  }
}

}  // namespace throng::anim
