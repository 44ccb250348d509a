#include "engine/anim/rig/ragdoll_limits.h"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "engine/anim/base/elementary.h"

namespace throng::anim {
namespace {

/// A person's own directions in the bind pose, whichever way the file turns the person.
struct Anatomy {
  glm::vec3 up{0.0F, 1.0F, 0.0F};
  glm::vec3 left{1.0F, 0.0F, 0.0F};
  glm::vec3 forward{0.0F, 0.0F, 1.0F};
};

glm::vec3 joint_of(const RagdollBody& body) { return body.center + body.joint; }

Anatomy anatomy_of(std::span<const RagdollBone> chosen, std::span<const RagdollBody> bodies) {
  glm::vec3 arms(0.0F);
  glm::vec3 hips(0.0F);
  glm::vec3 left(0.0F);
  for (std::size_t b = 0; b < chosen.size(); ++b) {
    const auto side = static_cast<float>(chosen[b].side);
    if (chosen[b].part == RagdollPart::upper_arm) arms += 0.5F * joint_of(bodies[b]);
    if (chosen[b].part == RagdollPart::thigh) hips += 0.5F * joint_of(bodies[b]);
    if (chosen[b].part == RagdollPart::thigh) left += side * joint_of(bodies[b]);
  }
  Anatomy anatomy;
  if (glm::length(left) < 1e-6F || glm::length(arms - hips) < 1e-6F) return anatomy;
  anatomy.left = glm::normalize(left);
  anatomy.forward = glm::normalize(glm::cross(anatomy.left, arms - hips));
  anatomy.up = glm::cross(anatomy.forward, anatomy.left);
  return anatomy;
}

/// Returns axes with x along a body and z as near to `across` as possible.
glm::quat axes_along(const glm::vec3& x, const glm::vec3& across) {
  glm::vec3 z = across - x * glm::dot(across, x);
  if (glm::length(z) < 1e-3F) z = glm::cross(x, std::abs(x.x) < 0.7F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
  z = glm::normalize(z);
  return glm::normalize(glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)));
}

glm::quat shortest_arc(const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine < -0.999F) return angle_axis(glm::radians(180.0F), axes_along(from, {}) * glm::vec3(0, 0, 1));
  const glm::vec3 axis = glm::cross(from, to);
  return glm::normalize(glm::quat(1.0F + cosine, axis.x, axis.y, axis.z));
}

/// Makes a cone around `neutral`; ranges are in degrees.
RagdollLimit cone(const glm::vec3& axis, const glm::vec3& neutral, float swing, float twist) {
  RagdollLimit limit{.swing = glm::radians(swing), .twist = glm::radians(twist)};
  limit.axes = axes_along(axis, {0.0F, 0.0F, 1.0F});
  limit.parent_axes = shortest_arc(axis, neutral) * limit.axes;
  return limit;
}

/// Makes a hinge that bends from straight, or a little further back, by `bend` degrees in the direction of `towards`.
RagdollLimit hinge(const glm::vec3& axis, const glm::vec3& parent_axis, const glm::vec3& towards, float bend,
                   float twist) {
  constexpr float beyond_straight = 3.0F;
  const float half = 0.5F * glm::radians(bend + beyond_straight);
  RagdollLimit limit{.hinge = true, .swing = half, .sideways = glm::radians(4.0F), .twist = glm::radians(twist)};
  limit.axes = axes_along(axis, glm::cross(axis, towards));
  const glm::vec3 turning = limit.axes * glm::vec3(0.0F, 0.0F, 1.0F);
  const float side = glm::dot(glm::cross(parent_axis, axis), turning);
  const auto bent =
      static_cast<float>(arc_tangent(static_cast<double>(side), static_cast<double>(glm::dot(parent_axis, axis))));
  const float middle = half - glm::radians(beyond_straight);
  limit.parent_axes = angle_axis(middle - bent, turning) * limit.axes;
  return limit;
}

RagdollLimit limit_of(const RagdollBone& bone, const glm::vec3& axis, const glm::vec3& parent_axis,
                      const Anatomy& body) {
  const glm::vec3 out = static_cast<float>(bone.side) * body.left;
  switch (bone.part) {
    case RagdollPart::pelvis:
    case RagdollPart::spine:
    case RagdollPart::chest:
      return cone(axis, axis, 25.0F, 25.0F);
    case RagdollPart::head:
      return cone(axis, axis, 45.0F, 55.0F);
    case RagdollPart::upper_arm:
      return cone(axis, glm::normalize(0.55F * out - 0.35F * body.up + 0.5F * body.forward), 95.0F, 75.0F);
    case RagdollPart::forearm:
      return hinge(axis, parent_axis, body.forward, 140.0F, 75.0F);
    case RagdollPart::hand:
      return cone(axis, axis, 60.0F, 20.0F);
    case RagdollPart::thigh:
      return cone(axis, glm::normalize(0.2F * out - 0.8F * body.up + 0.55F * body.forward), 65.0F, 35.0F);
    case RagdollPart::shin:
      return hinge(axis, parent_axis, -body.forward, 140.0F, 10.0F);
    case RagdollPart::foot:
      return cone(axis, axis, 35.0F, 15.0F);
    case RagdollPart::other:
      break;
  }
  return cone(axis, axis, 40.0F, 30.0F);
}

}  // namespace

void set_ragdoll_limits(std::span<const RagdollBone> chosen, std::span<RagdollBody> bodies) {
  const Anatomy anatomy = anatomy_of(chosen, bodies);
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    const RagdollBody& parent = bodies[static_cast<std::size_t>(bodies[b].parent)];
    bodies[b].limit = limit_of(chosen[b], bodies[b].axis, parent.axis, anatomy);
  }
}

}  // namespace throng::anim
