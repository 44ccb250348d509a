#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// The joints at which a limb bends, by bone index. Each is below the one before, perhaps with bones in between, unless
/// the end stands apart.
struct LimbBones {
  int upper = -1;                 ///< hip or shoulder joint
  int middle = -1;                ///< knee or elbow
  int end = -1;                   ///< ankle or wrist
  int tip = -1;                   ///< ball of the foot; -1 where there is none, and for arms
  bool end_stands_apart = false;  ///< the end has keys of its own and is no bone below the middle, as in rigs whose
                                  ///< feet stay behind when their IK is baked
};

/// The body in a skeleton. A limb that is uncertain is left out, and a doubt says why.
struct Limbs {
  std::optional<LimbBones> left_leg;
  std::optional<LimbBones> right_leg;
  std::optional<LimbBones> left_arm;
  std::optional<LimbBones> right_arm;
  std::optional<int> pelvis;  ///< the lowest bone that carries both legs; without legs, the bone of that name
  std::vector<int> spine;     ///< bones between pelvis and head, from below, neck included
  std::optional<int> head;
  glm::vec3 forward{0.0F, 0.0F, 1.0F};  ///< direction that the body faces in the bind pose, model space, unit, level
  bool named = false;                   ///< legs were found by their names, not by the shape of the skeleton
  std::vector<std::string> doubts;      ///< one sentence each
};

/// Finds limbs by the roles that the file or a person gives to bones (Bone::role), else by their names (Mixamo, Rigify,
/// Unreal, VRM, Biped and their like). Where no leg has a name that can be read, finds them by shape: pairs of chains
/// that mirror each other. Checks left and right against the bind pose: a pair must lie apart and its toes point
/// forward, or it is left out.
Limbs find_limbs(const Skeleton& skeleton);

}  // namespace throng::anim
