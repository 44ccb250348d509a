#pragma once

#include <span>
#include <vector>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {

/// Where a body's capsule lies in the bind pose, model space.
struct RagdollShape {
  glm::dvec3 joint{0.0};
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
  double radius = 0.0;
};

/// One capsule a chosen bone: from its origin to where the next one starts, as thick as the surface around it is, or as
/// a person's part of that length where there is no surface.
std::vector<RagdollShape> fit_ragdoll_shapes(const Model& model, std::span<const RagdollBone> chosen);

/// Centre, capsule, mass and inertia of every body, from shapes of even density.
void set_ragdoll_masses(std::span<const RagdollShape> shapes, double mass, std::span<RagdollBody> bodies);

}  // namespace throng::anim
