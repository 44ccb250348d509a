#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/rig/limbs.h"

namespace throng::anim {

/// The places of a skeleton's joints in the bind pose, or in the rest pose on the general path.
struct JointMap {
  /// The skeleton must outlive the map.
  explicit JointMap(const Skeleton& of);
  glm::vec3 at(int bone) const { return places[static_cast<std::size_t>(bone)]; }
  /// Returns the way from one joint to another without its vertical part.
  glm::vec3 level(int from, int to) const;

  const Skeleton& skeleton;
  std::vector<std::vector<int>> children;
  std::vector<glm::vec3> places;  ///< model space, metres
  float lowest = 0.0F;
  float height = 0.0F;  ///< metres from the lowest joint to the highest
};

/// Two limbs that mirror each other. It is not yet known which one is left.
using LimbPair = std::pair<LimbBones, LimbBones>;

/// Finds a pair of chains of three or four joints that hang down to the ground; nothing unless there is exactly one.
std::optional<LimbPair> find_leg_shapes(const JointMap& joints);
/// Finds a pair of chains of three joints that begin above the legs; nothing unless there is exactly one.
std::optional<LimbPair> find_arm_shapes(const JointMap& joints, const LimbPair& legs);

/// Returns the end of the one chain that goes up from where the arms begin; -1 if there is none or several.
int find_head_shape(const JointMap& joints, const LimbBones& left_arm, const LimbBones& right_arm);

/// Returns where the toes point, level and at right angles to the line between the legs; nothing without toes.
std::optional<glm::vec3> toe_direction(const JointMap& joints, const LimbPair& legs);

}  // namespace throng::anim
