#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// The joints at which a limb bends, by bone index; each is below the one before, perhaps with bones between.
struct LimbBones {
  int upper = -1;   ///< hip or shoulder joint
  int middle = -1;  ///< knee or elbow
  int end = -1;     ///< ankle or wrist
  int tip = -1;     ///< ball of the foot; -1 where there is none, and for arms
};

/// The body in a skeleton. What could not be told for certain is not there, and a doubt says why.
struct Limbs {
  std::optional<LimbBones> left_leg;
  std::optional<LimbBones> right_leg;
  std::optional<LimbBones> left_arm;
  std::optional<LimbBones> right_arm;
  std::optional<int> pelvis;  ///< the lowest bone that carries both legs; without legs, the bone called so
  std::vector<int> spine;     ///< between pelvis and head, from below, neck included
  std::optional<int> head;
  glm::vec3 forward{0.0F, 0.0F, 1.0F};  ///< where the body faces in the bind pose, model space, unit, level
  bool named = false;                   ///< legs were found by their names; else by the shape of the skeleton
  std::vector<std::string> doubts;      ///< one sentence each
};

/// Finds limbs by the names of bones (Mixamo, Rigify, Unreal, VRM, Biped and their like), and where they have none that
/// can be read, by shape: pairs of chains that mirror each other. Left and right are held against the bind pose: pairs
/// must lie apart and toes point forward, or the pair is left out.
Limbs find_limbs(const Skeleton& skeleton);

}  // namespace throng::anim
