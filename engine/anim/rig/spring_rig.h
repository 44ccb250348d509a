#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/base/result.h"

namespace throng::anim {

inline constexpr std::size_t max_spring_chains = 16;
inline constexpr std::size_t max_spring_joints = 64;
inline constexpr std::size_t max_spring_colliders = 16;
inline constexpr std::size_t max_spring_nodes = 128;  ///< bones from the roots down to all of these

/// The movement of a chain of bones, such as a plait or a strip of a skirt. The words are those of VRM's spring bones
/// (VRMC_springBone 1.0, "Joint"); the units are physical, so that the result does not depend on the frame rate.
struct SpringOptions {
  float stiffness = 80.0F;               ///< per second squared: pulls a bone back to its pose
  float damping = 6.0F;                  ///< per second: slows a bone relative to the joint that carries it
  float drag = 1.0F;                     ///< per second: slows it relative to the air
  glm::vec3 gravity{0.0F, -3.0F, 0.0F};  ///< metres per second squared, world: beyond the pose's
  float radius = 0.02F;                  ///< metres that the end of each bone keeps from colliders and the ground
};

/// The bones of a chain, by name: all from `first` down to `last`.
struct SpringChain {
  std::string first;
  std::string last;
  SpringOptions options{};
  float tip = 0.0F;  ///< metres that the last bone reaches beyond its joint, on in the direction of the one before it.
                     ///< 0: it only ends the chain, and does not turn
};

/// A sphere or capsule of the body that chains stay outside of.
struct SpringCollider {
  std::string bone;
  glm::vec3 from{0.0F};  ///< metres from the bone's joint, bind pose
  glm::vec3 to{0.0F};    ///< the same as `from`: a sphere
  float radius = 0.1F;
};

/// A bone that must be posed to know where chains and colliders are.
struct SpringNode {
  int bone = 0;
  int parent = -1;         ///< index of a node before it; -1 for a root
  glm::vec3 offset{0.0F};  ///< metres from the parent's joint, bind pose; for a root, from the origin
};

/// A bone that swings.
struct SpringJoint {
  int node = 0;
  glm::vec3 tail{0.0F};  ///< metres from its joint to its end, bind pose
  float length = 0.0F;   ///< of `tail`
};

/// Everything that springs know of a skeleton. It is made at load and shared by every character of the skeleton.
struct SpringRig {
  struct Chain {
    int first = 0;  ///< of joints
    int count = 0;
    int base = -1;  ///< the node that carries the first joint; -1: model space
    SpringOptions options{};
  };
  struct Collider {
    int node = 0;
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F};
    float radius = 0.0F;
  };

  std::vector<SpringNode> nodes;    ///< parents first
  std::vector<SpringJoint> joints;  ///< chain by chain, each from its root down
  std::vector<Chain> chains;
  std::vector<Collider> colliders;
  int bone_end = 0;  ///< bones from here on are neither read nor changed
};

/// Makes a rig. Errors: no chains; more than the limits above; a bone that the skeleton lacks or has twice by this
/// name; a `last` that is not below its `first`; a bone in two chains; a chain without length; options that are
/// negative or not finite; skeletons on the general path, because rotations alone do not describe their scales.
Result<SpringRig> make_spring_rig(const Skeleton& skeleton, std::span<const SpringChain> chains,
                                  std::span<const SpringCollider> colliders = {});

}  // namespace throng::anim
