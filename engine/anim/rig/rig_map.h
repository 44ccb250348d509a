#pragma once

#include <array>

#include "engine/anim/asset/body_role.h"
#include "engine/anim/rig/limbs.h"

namespace throng::anim {

/// The bone that plays each part of a body, and the limbs that they form.
struct RigMap {
  std::array<int, body_role_count> bones{};  ///< by BodyRole; -1 where no bone plays it for certain
  Limbs limbs;

  int at(BodyRole role) const { return bones[index_of(role)]; }
};

/// Finds the parts of a skeleton. A role of the file or of a person (Bone::role) counts as it is. The limbs say the
/// rest, and names alone where a limb is incomplete. `chest` is the bone that carries both arms, unless said otherwise.
RigMap find_rig(const Skeleton& skeleton);

}  // namespace throng::anim
