#include "engine/anim/kernel/limb/foot_placement.h"

#include <algorithm>
#include <set>
#include <string>

namespace throng::anim {

namespace {

std::span<const PlacedLeg> legs_of(const FootPlacementRig& rig) {
  return std::span(rig.legs).first(static_cast<std::size_t>(rig.leg_count));
}

/// The last joint that all chains begin with, above every hip; -1 if there is none.
int carrying_joint(const FootPlacementRig& rig) {
  for (int joint = 0;; ++joint) {
    for (int leg = 0; leg < rig.leg_count; ++leg) {
      const TwoBoneLimb& limb = rig.legs[static_cast<std::size_t>(leg)].limb;
      const auto j = static_cast<std::size_t>(joint);
      if (joint >= limb.upper || limb.chain.bones[j] != rig.legs[0].limb.chain.bones[j]) return joint - 1;
    }
  }
}

std::size_t quads_of(const FootPlacementRig& rig) {
  std::set<int> quads;
  for (const PlacedLeg& leg : legs_of(rig)) {
    for (const int bone : std::span(leg.limb.chain.bones).first(static_cast<std::size_t>(leg.limb.chain.count))) {
      quads.insert(bone / quad_bones);
    }
  }
  return quads.size();
}

}  // namespace

Result<FootPlacementRig> make_foot_placement_rig(const Skeleton& skeleton, std::span<const LegBones> legs,
                                                 float sole_height, const glm::vec3& forward) {
  if (legs.empty() || legs.size() > static_cast<std::size_t>(max_legs)) {
    return Error{"feet of skeleton '" + skeleton.name + "' cannot be placed on " + std::to_string(legs.size()) +
                 " legs: name 1 to " + std::to_string(max_legs)};
  }
  FootPlacementRig rig;
  for (const LegBones& bones : legs) {
    Result<TwoBoneLimb> limb = make_two_bone_limb(skeleton, bones.hip, bones.knee, bones.ankle, forward);
    if (!limb) return limb.error();
    if (bones.toe >= skeleton.bone_count()) return make_joint_chain(skeleton, bones.toe).error();
    const auto origin = [&](int bone) { return glm::vec3(skeleton.references[static_cast<std::size_t>(bone)].origin); };
    const glm::vec3 ankle = origin(bones.ankle);
    const glm::vec3 ball = bones.toe < 0 ? ankle : origin(bones.toe);
    rig.legs[static_cast<std::size_t>(rig.leg_count++)] = {
        .limb = *limb,
        .sole = {glm::vec3(0.0F, sole_height - ankle.y, 0.0F),
                 bones.toe < 0 ? glm::vec3(0.0F, sole_height - ankle.y, 0.0F) : ball - ankle},
        .ball_height = bones.toe < 0 ? 0.0F : ball.y - sole_height};
  }
  rig.pelvis = carrying_joint(rig);
  if (rig.pelvis < 0) {
    return Error{"no bone of skeleton '" + skeleton.name +
                 "' carries all its legs, so none can be lowered: parent them"};
  }
  for (const PlacedLeg& leg : legs_of(rig)) rig.bone_end = std::max(rig.bone_end, leg.limb.chain.bone_end());
  if (quads_of(rig) > std::size_t{most_leg_quads}) {
    return Error{"the legs of skeleton '" + skeleton.name + "' have joints in " + std::to_string(quads_of(rig)) +
                 " groups of four bones, of which feet are placed over at most " + std::to_string(most_leg_quads) +
                 ": name fewer legs"};
  }
  return rig;
}

void forget_feet(const FootPlacementJob& job) {
  job.body->started = false;
  job.body->drop = {};
  for (PlacedFoot& foot : std::span(job.feet, static_cast<std::size_t>(job.rig->leg_count))) {
    foot.lock = {};
    foot.missed_by = 0.0F;
    foot.reached = 1.0F;
  }
}

}  // namespace throng::anim
