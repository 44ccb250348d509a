#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/kernel/ragdoll/ragdoll.h"
#include "engine/anim/rig/ragdoll_rig.h"

/// Creatures made by hand, poses to write to, and what the rag-doll tests measure.
namespace throng::anim::ragdoll_stage {

/// Returns a person 1.75 m tall with the bones of the built-in mannequin, fingers and face left out.
Model person();
/// Returns a straight chain of bones of 10 cm, a metre above the ground.
Model chain(int bones);
/// Returns a head with eight arms of six bones of 12 cm each.
Model octopus();

RagdollRig rig_of(const Model& model);

/// A pose in memory of its own, as pose.h draws it. It begins as the bind pose.
class Pose {
 public:
  explicit Pose(int bones);
  PoseView view() { return {packets_.front().lanes, rigid_components * packet_bones, rigid_components, bones_}; }

 private:
  struct alignas(64) Packet {
    float lanes[rigid_components * packet_bones];
  };
  int bones_;
  std::vector<Packet> packets_;
};

/// Returns a person in the bind pose, tipping over.
RagdollState standing(const RagdollRig& rig);
/// Returns the same after so many seconds on level ground.
RagdollState fallen(const RagdollRig& rig, double seconds);

void run(const RagdollRig& rig, double seconds, RagdollState& state, const GroundPlane& ground = {});

/// Returns the model-space origins of all bones of a pose, by the definition of ReferenceFrame in double.
std::vector<glm::dvec3> bone_origins(const Skeleton& skeleton, const PoseView& pose);
/// Returns the same for the pose that a rag-doll writes over the bind pose.
std::vector<glm::dvec3> bone_origins(const Model& model, const RagdollRig& rig, const RagdollState& state);

glm::vec3 joint_of(const RagdollRig& rig, const RagdollState& state, int body);
/// Returns how far the lowest point of any capsule is below a plane; negative above.
float deepest(const RagdollRig& rig, const RagdollState& state, const GroundPlane& ground = {});
/// Returns the largest distance between the two sides of a joint.
float widest_gap(const RagdollRig& rig, const RagdollState& state);
/// Returns the largest angle in radians by which a joint is outside its limits.
double farthest_outside_limits(const RagdollRig& rig, const RagdollState& state);
/// Returns the energy of movement and height of all bodies, in joules.
double energy(const RagdollRig& rig, const RagdollState& state);

bool same_bits(const RagdollState& a, const RagdollState& b);
bool is_finite(const RagdollRig& rig, const RagdollState& state);

}  // namespace throng::anim::ragdoll_stage
