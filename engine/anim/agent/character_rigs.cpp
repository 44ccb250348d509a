#include "engine/anim/agent/character_rigs.h"

#include <algorithm>
#include <utility>

#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/entity/ik_entity.h"
#include "engine/anim/entity/look_at_entity.h"
#include "engine/anim/entity/ragdoll_entity.h"

namespace throng::anim {
namespace {

// Shares of a turn: the neck makes twice, the head four times what each bone of the back makes.
constexpr float neck_share = 2.0F;
constexpr float head_share = 4.0F;

// Eyes as a person has them: above the head joint and before it, as shares of that joint's height.
constexpr float eyes_above = 0.05F;
constexpr float eyes_before = 0.05F;

std::vector<LookBone> look_bones(const Limbs& limbs) {
  std::vector<LookBone> bones;
  for (const int bone : limbs.spine) bones.push_back({.bone = bone});
  if (!bones.empty()) bones.back().weight = neck_share;
  bones.push_back({.bone = *limbs.head, .weight = head_share});
  const auto most = static_cast<std::ptrdiff_t>(max_look_joints);
  if (std::ssize(bones) > most) bones.erase(bones.begin(), bones.end() - most);
  return bones;
}

LegBones leg_of(const LimbBones& bones) {
  return {.hip = bones.upper, .knee = bones.middle, .ankle = bones.end, .toe = bones.tip};
}

void reorder(JointChain& chain, std::span<const int> places) {
  for (std::int16_t& bone : std::span(chain.bones).first(static_cast<std::size_t>(chain.count))) {
    bone = static_cast<std::int16_t>(places[static_cast<std::size_t>(bone)]);
  }
}

}  // namespace

CharacterRigs::CharacterRigs(const Model& model, const RagdollOptions& ragdoll) {
  find_limbs_of(model.skeleton);
  Result<RagdollRig> falling = build_ragdoll_rig(model, ragdoll);
  if (falling) {
    take(std::move(*falling));
  } else {
    missing_.push_back(falling.error().message);
  }
}

CharacterRigs::CharacterRigs(const Skeleton& skeleton, RagdollRig ragdoll) {
  find_limbs_of(skeleton);
  take(std::move(ragdoll));
}

void CharacterRigs::take(RagdollRig ragdoll) {
  ragdoll_ = std::move(ragdoll);
  ragdoll_kind_ = ragdoll_kind(*ragdoll_);
}

void CharacterRigs::find_limbs_of(const Skeleton& skeleton) {
  const Limbs limbs = find_limbs(skeleton);
  missing_ = limbs.doubts;
  find_gaze(skeleton, limbs);
  find_feet(skeleton, limbs);
  find_limb(skeleton, limbs.left_arm, Limb::left_arm, -limbs.forward);
  find_limb(skeleton, limbs.right_arm, Limb::right_arm, -limbs.forward);
  find_limb(skeleton, limbs.left_leg, Limb::left_leg, limbs.forward);
  find_limb(skeleton, limbs.right_leg, Limb::right_leg, limbs.forward);
  if (!limbs_.empty()) ik_kind_ = ik_kind(limbs_);
}

void CharacterRigs::find_gaze(const Skeleton& skeleton, const Limbs& limbs) {
  if (!limbs.head) {
    missing_.push_back("skeleton '" + skeleton.name + "' cannot look at things: no bone is its head for certain");
    return;
  }
  const auto height = static_cast<float>(skeleton.references[static_cast<std::size_t>(*limbs.head)].origin.y);
  const glm::vec3 eyes = eyes_above * height * glm::vec3(0.0F, 1.0F, 0.0F) + eyes_before * height * limbs.forward;
  const Result<LookAtRig> rig = make_look_at_rig(skeleton, look_bones(limbs), limbs.forward, eyes);
  if (!rig) {
    missing_.push_back(rig.error().message);
    return;
  }
  look_at_ = *rig;
  look_at_kind_ = look_at_kind(*look_at_);
}

void CharacterRigs::find_feet(const Skeleton& skeleton, const Limbs& limbs) {
  std::vector<LegBones> legs;
  for (const auto& leg : {limbs.left_leg, limbs.right_leg}) {
    if (leg && leg->end_stands_apart) {
      missing_.push_back("skeleton '" + skeleton.name +
                         "' has feet that stand apart from its legs, so they keep the clip's place on uneven ground");
      return;
    }
    if (leg) legs.push_back(leg_of(*leg));
  }
  const Result<FootPlacementRig> rig = make_foot_placement_rig(skeleton, legs, 0.0F, limbs.forward);
  if (!rig) {
    missing_.push_back(rig.error().message);
    return;
  }
  foot_placement_ = *rig;
  foot_placement_kind_ = foot_placement_kind(*foot_placement_);
}

void CharacterRigs::find_limb(const Skeleton& skeleton, const std::optional<LimbBones>& bones, Limb limb,
                              const glm::vec3& bends) {
  if (!bones || bones->end_stands_apart) return;  // find_feet() says so
  const Result<TwoBoneLimb> made = make_two_bone_limb(skeleton, bones->upper, bones->middle, bones->end, bends);
  if (!made) {
    missing_.push_back(made.error().message);
    return;
  }
  limb_places_[static_cast<std::size_t>(limb)] = static_cast<std::uint32_t>(limbs_.size());
  limbs_.push_back(*made);
}

// The kinds say up to which bone they read, so they are made anew where they lie.
void CharacterRigs::reorder_bones(std::span<const int> places) {
  if (look_at_) {
    reorder(look_at_->chain, places);
    look_at_kind_ = look_at_kind(*look_at_);
  }
  if (foot_placement_) {
    int bone_end = 0;
    for (PlacedLeg& leg : foot_placement_->legs) {
      reorder(leg.limb.chain, places);
      bone_end = std::max(bone_end, leg.limb.chain.bone_end());
    }
    foot_placement_->bone_end = bone_end;
    foot_placement_kind_ = foot_placement_kind(*foot_placement_);
  }
  for (TwoBoneLimb& limb : limbs_) reorder(limb.chain, places);
  if (!limbs_.empty()) ik_kind_ = ik_kind(limbs_);
  if (!ragdoll_) return;
  for (RagdollBody& body : ragdoll_->bodies) body.bone = places[static_cast<std::size_t>(body.bone)];
  for (RagdollLink& link : ragdoll_->links) link.bone = places[static_cast<std::size_t>(link.bone)];
  ragdoll_kind_ = ragdoll_kind(*ragdoll_);
}

const EntityKind* CharacterRigs::kind(EntityType type) const {
  switch (type) {
    case EntityType::look_at:
      return look_at_ ? &look_at_kind_ : nullptr;
    case EntityType::foot_placement:
      return foot_placement_ ? &foot_placement_kind_ : nullptr;
    case EntityType::two_bone_ik:
      return limbs_.empty() ? nullptr : &ik_kind_;
    case EntityType::ragdoll:
      return ragdoll_ ? &ragdoll_kind_ : nullptr;
    default:
      return nullptr;
  }
}

RigKinds CharacterRigs::add_to(AnimationSystem& system, CharacterId character) const {
  const auto added = [&](EntityType type) -> std::optional<EntityPools::Kind> {
    const EntityKind* const own = kind(type);
    if (own == nullptr) return std::nullopt;
    const Result<EntityPools::Kind> number = system.characters().add_entity_kind(*own, character);
    return number ? std::optional(*number) : std::nullopt;
  };
  return {.look_at = added(EntityType::look_at),
          .foot_placement = added(EntityType::foot_placement),
          .limbs = added(EntityType::two_bone_ik),
          .ragdoll = added(EntityType::ragdoll)};
}

}  // namespace throng::anim
