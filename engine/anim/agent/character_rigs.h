#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/processes.h"

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/limb/foot_placement.h"
#include "engine/anim/kernel/limb/look_at.h"
#include "engine/anim/kernel/ragdoll/ragdoll.h"
#include "engine/anim/rig/limbs.h"

namespace throng::anim {

/// The kinds of entities of one character in one system, with which post processes are made. A kind is empty where the
/// character has no such rig, or no more kinds can be added.
struct RigKinds {
  std::optional<EntityPools::Kind> look_at;
  std::optional<EntityPools::Kind> foot_placement;
  std::optional<EntityPools::Kind> limbs;
  std::optional<EntityPools::Kind> ragdoll;
};

/// The rigs of a character, with which it can look, stand, reach and fall. They are found once, at load. The object
/// outlives the systems that it was added to, which keep pointers into it.
class CharacterRigs {
 public:
  using Limb = throng::Limb;

  /// Finds the rigs of an imported model, whose skeleton is the character's.
  explicit CharacterRigs(const Model& model, const RagdollOptions& ragdoll = {});
  /// Takes a rag-doll that was built of the model before.
  CharacterRigs(const Skeleton& skeleton, RagdollRig ragdoll);
  CharacterRigs(const CharacterRigs&) = delete;
  CharacterRigs& operator=(const CharacterRigs&) = delete;

  /// Adds the rigs to a character of a system, of which they take up to four of EntityPools::most_kinds. Call it once,
  /// before its agents use them.
  RigKinds add_to(AnimationSystem& system, CharacterId character = 0) const;

  /// Returns the kind of entity of a rig; null where the character has no such rig.
  const EntityKind* kind(EntityType type) const;

  /// Takes another order of the character's bones; `places` has the new index of each. The memory that systems point at
  /// stays where it is; see Characters::replace.
  void reorder_bones(std::span<const int> places);

  const std::optional<LookAtRig>& look_at() const { return look_at_; }
  const std::optional<FootPlacementRig>& foot_placement() const { return foot_placement_; }
  const std::optional<RagdollRig>& ragdoll() const { return ragdoll_; }
  /// Returns the number of a limb for ReachProcess; nothing where the character has no such limb.
  std::optional<std::uint32_t> limb(Limb limb) const { return limb_places_[static_cast<std::size_t>(limb)]; }
  /// Returns the reasons why rigs are missing, one sentence each.
  std::span<const std::string> missing() const { return missing_; }

 private:
  void find_limbs_of(const Skeleton& skeleton);
  void take(RagdollRig ragdoll);
  void find_gaze(const Skeleton& skeleton, const Limbs& limbs);
  void find_feet(const Skeleton& skeleton, const Limbs& limbs);
  void find_limb(const Skeleton& skeleton, const std::optional<LimbBones>& bones, Limb limb, const glm::vec3& bends);

  std::optional<LookAtRig> look_at_;
  std::optional<FootPlacementRig> foot_placement_;
  std::vector<TwoBoneLimb> limbs_;
  std::array<std::optional<std::uint32_t>, 4> limb_places_;
  std::optional<RagdollRig> ragdoll_;
  std::vector<std::string> missing_;
  EntityKind look_at_kind_;
  EntityKind foot_placement_kind_;
  EntityKind ik_kind_;
  EntityKind ragdoll_kind_;
};

}  // namespace throng::anim
