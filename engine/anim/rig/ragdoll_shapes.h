#pragma once

#include <span>
#include <vector>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {

/// A body's capsule in the bind pose, in model space.
struct RagdollShape {
  glm::dvec3 joint{0.0};
  glm::dvec3 from{0.0};
  glm::dvec3 to{0.0};
  double radius = 0.0;
};

/// Fits a capsule to each chosen bone, from its origin to where the next one starts. It is as thick as the surface
/// around it, or as a person's part of that length where there is no surface.
std::vector<RagdollShape> fit_ragdoll_shapes(const Model& model, std::span<const RagdollBone> chosen);

/// Sets centre, capsule, mass and inertia of every body; all shapes have the same density.
void set_ragdoll_masses(std::span<const RagdollShape> shapes, double mass, std::span<RagdollBody> bodies);

}  // namespace throng::anim
