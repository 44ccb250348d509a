#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

enum class RagdollPart : std::uint8_t {
  pelvis,
  spine,
  chest,
  head,
  upper_arm,
  forearm,
  hand,
  thigh,
  shin,
  foot,
  other  ///< of what is not a person
};

/// A bone that becomes a body.
struct RagdollBone {
  int bone = 0;
  int parent = -1;  ///< entry that it hangs on, below its own; -1 for the first
  RagdollPart part = RagdollPart::other;
  int side = 0;  ///< 1 left, -1 right
};

/// The person whom the names tell of: both upper arms, forearms, thighs and shins, and what there is of hands, feet,
/// head, spine and chest. Empty where one of the eight is missing or not where it belongs.
std::vector<RagdollBone> choose_humanoid_bones(const Skeleton& skeleton);

/// For any other skeleton: bones are joined with their parents, shortest first, until at most max_ragdoll_bodies
/// are left and none is tiny. Bones without any surface at or below them are left out, if the model has a surface.
std::vector<RagdollBone> choose_longest_bones(const Model& model);

}  // namespace throng::anim
