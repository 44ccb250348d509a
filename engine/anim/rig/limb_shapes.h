#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/rig/limbs.h"

namespace throng::anim {

/// Where the joints of a skeleton are in the bind pose (of skeletons on the general path: in the rest pose).
struct JointMap {
  explicit JointMap(const Skeleton& skeleton);
  glm::vec3 at(int bone) const { return places[static_cast<std::size_t>(bone)]; }
  /// From one joint to another, without what is vertical.
  glm::vec3 level(int from, int to) const;

  std::vector<int> parents;
  std::vector<std::vector<int>> children;
  std::vector<glm::vec3> places;  ///< model space, metres
  float lowest = 0.0F;
  float height = 0.0F;  ///< metres from the lowest joint to the highest
};

bool is_below(const JointMap& joints, int bone, int ancestor);
/// The lowest bone above both, or -1.
int common_ancestor(const JointMap& joints, int a, int b);

/// Two limbs that mirror each other; which is which side is not known yet.
using LimbPair = std::pair<LimbBones, LimbBones>;

/// A pair of chains of three or four joints that hang down to the ground. Nothing where there is no such pair, or two.
std::optional<LimbPair> find_leg_shapes(const JointMap& joints);
/// A pair of chains of three joints that begin above the legs. Nothing where there is no such pair, or two.
std::optional<LimbPair> find_arm_shapes(const JointMap& joints, const LimbPair& legs);

/// The end of the one chain that goes on up from where the arms begin; -1 if it cannot be told.
int find_head_shape(const JointMap& joints, const LimbBones& left_arm, const LimbBones& right_arm);

/// Where toes point, level and at a right angle to the line between the legs; nothing without toes.
std::optional<glm::vec3> toe_direction(const JointMap& joints, const LimbPair& legs);

}  // namespace throng::anim
