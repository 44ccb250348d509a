#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The most bones that a rag-doll (paper 2.2.6) simulates. The others keep their pose and follow.
inline constexpr int max_ragdoll_bodies = 16;

/// The limits of a body's turn against its parent: half ranges in radians around a neutral pose. The x axis of both
/// frames runs along the body. A turn about it is twist, and a turn that moves it is swing.
///
///     cone:   the child's x axis stays within `swing` of the parent's
///     hinge:  it turns about the parent's z axis by at most `swing`, and leaves the plane by at most `sideways`
struct RagdollLimit {
  glm::quat parent_axes{1.0F, 0.0F, 0.0F, 0.0F};  ///< neutral joint axes -> parent body
  glm::quat axes{1.0F, 0.0F, 0.0F, 0.0F};         ///< joint axes -> this body
  bool hinge = false;
  float swing = 0.0F;
  float sideways = 0.0F;
  float twist = 0.0F;
};

/// A body of the rag-doll, a capsule. It has the axes of model space in the bind pose, as states do (see
/// ReferenceFrame), so its rotation is the model-space motion of its bone.
struct RagdollBody {
  int bone = 0;
  int parent = -1;         ///< the body that it hangs on, of a lower index; -1 for the first
  int pose_parent = -1;    ///< the body of its nearest ancestor bone; differs from `parent` in rigs that keep
                           ///< feet beside the legs. -1: model space
  int first_link = 0;      ///< first bone of the way from there to its own: rig.links[first_link + 0..link_count)
  int link_count = 0;      ///< the last link is its own bone
  glm::vec3 center{0.0F};  ///< centre of mass in the bind pose, model space
  glm::vec3 joint{0.0F};   ///< origin of its bone in the bind pose, from the centre of mass
  glm::vec3 joint_in_parent{0.0F};   ///< the same from the centre of the body that it hangs on
  glm::vec3 axis{0.0F, 1.0F, 0.0F};  ///< unit; the capsule's ends are centre -/+ axis * half_length
  float half_length = 0.0F;
  float radius = 0.0F;
  float inverse_mass = 0.0F;           ///< 1 / kg
  float inverse_inertia = 0.0F;        ///< 1 / (kg m^2), across the axis
  float inverse_axial_inertia = 0.0F;  ///< along it
  RagdollLimit limit{};                ///< against the body that it hangs on; unused in the first
};

/// One bone of the way from one body's bone down to the next.
struct RagdollLink {
  int bone = 0;
  glm::vec3 offset{0.0F};  ///< from its parent's origin in the bind pose; for a root, from model space's origin
};

/// Everything that a rag-doll knows of a skeleton. Read-only; built at load, once the bones have their final order.
struct RagdollRig {
  std::vector<RagdollBody> bodies;  ///< 2 to max_ragdoll_bodies, parents first
  std::vector<RagdollLink> links;
  float metre = 1.0F;  ///< length of a metre in model space
};

struct RagdollOptions {
  double mass = 70.0;  ///< kg, all bodies together
  double metre = 1.0;  ///< length of a metre in model space; gravity is 9.81 of these per second squared
};

/// Builds a rig of the main bones of a person, found by their parts (rig_map.h). Where
/// some are missing, takes the longest groups of bones instead. Fits capsules to the surface, or guesses them from the
/// bones where there is none. Refuses, with a sentence, skeletons that are not rigid or have a single bone.
Result<RagdollRig> build_ragdoll_rig(const Model& model, const RagdollOptions& options = {});

}  // namespace throng::anim
