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
  other  ///< any part of another creature
};

/// A bone that becomes a body of the rag-doll.
struct RagdollBone {
  int bone = 0;
  int parent = -1;  ///< the entry that it hangs on, of a lower index; -1 for the first
  RagdollPart part = RagdollPart::other;
  int side = 0;  ///< 1 left, -1 right
};

/// Chooses a person's bones by their parts (rig_map.h): both upper arms, forearms, thighs and shins, and the hands,
/// feet, head, spine and chest that there are. Returns none if one of the first eight is missing or out of place, or
/// the arms do not begin above the legs.
std::vector<RagdollBone> choose_humanoid_bones(const Skeleton& skeleton);

/// Chooses bones of any other skeleton. Joins bones with their parents, shortest first, until at most
/// max_ragdoll_bodies are left and none is tiny. If the model has a surface, leaves out bones without any of it at or
/// below them.
std::vector<RagdollBone> choose_longest_bones(const Model& model);

}  // namespace throng::anim
