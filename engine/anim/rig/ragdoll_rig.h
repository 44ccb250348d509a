#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/result.h"

namespace throng::anim {

/// A rag-doll (paper 2.2.6) simulates at most so many bones; the others keep their pose and follow.
inline constexpr int max_ragdoll_bodies = 16;

/// How far a body may turn against its parent, in radians: half ranges around a neutral pose. The x axis of both frames
/// runs along the body, so that turning about it is twist and leaving it is swing.
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

/// A capsule. Bodies have the axes of model space in the bind pose, as states do (see ReferenceFrame), so the rotation
/// of a body is the model-space motion of its bone.
struct RagdollBody {
  int bone = 0;
  int parent = -1;       ///< body that it hangs on, below its own index; -1 for the first
  int pose_parent = -1;  ///< body of its nearest ancestor bone, which is not always the one it hangs on: some rigs keep
                         ///< feet beside the legs. -1: model space
  int first_link = 0;    ///< bones from there to its own: rig.links[first_link, first_link + link_count)
  int link_count = 0;    ///< the last is its own
  glm::vec3 center{0.0F};            ///< centre of mass in the bind pose, model space
  glm::vec3 joint{0.0F};             ///< origin of its bone in the bind pose, from the centre
  glm::vec3 joint_in_parent{0.0F};   ///< the same from the centre of the body that it hangs on
  glm::vec3 axis{0.0F, 1.0F, 0.0F};  ///< unit; the capsule's ends are centre -/+ axis * half_length
  float half_length = 0.0F;
  float radius = 0.0F;
  float inverse_mass = 0.0F;           ///< 1 / kg
  float inverse_inertia = 0.0F;        ///< 1 / (kg m^2), across the axis
  float inverse_axial_inertia = 0.0F;  ///< along it
  RagdollLimit limit{};                ///< against the body that it hangs on; unused in the first
};

/// One bone of the way from a body's bone down to the next.
struct RagdollLink {
  int bone = 0;
  glm::vec3 offset{0.0F};  ///< from its parent's origin to its own in the bind pose; from model space's for a root
};

/// What a rag-doll needs to know of a skeleton. Read-only; built at load, once the bones have their final order.
struct RagdollRig {
  std::vector<RagdollBody> bodies;  ///< 2 to max_ragdoll_bodies, parents first
  std::vector<RagdollLink> links;
  float metre = 1.0F;  ///< length of a metre in model space
};

struct RagdollOptions {
  double mass = 70.0;  ///< kg, all bodies together
  double metre = 1.0;  ///< length of a metre in model space; what falls, falls with 9.81 of these per second squared
};

/// Finds the main bones of a person by their names (Mixamo, Rigify, Unreal, VRM and the like) or, where those are not
/// all there, the longest groups of bones of whatever has grown. Capsules are fitted to the surface, or guessed from
/// the bones where there is none. Refused, with a sentence: skeletons that are not rigid, and those with a single bone.
Result<RagdollRig> build_ragdoll_rig(const Model& model, const RagdollOptions& options = {});

}  // namespace throng::anim
