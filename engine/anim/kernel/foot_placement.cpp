#include "engine/anim/kernel/foot_placement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/rotations.h"

namespace throng::anim {

namespace {

constexpr glm::vec3 up{0.0F, 1.0F, 0.0F};
constexpr float steepest_ground = 0.2F;  // least y of a normal; steeper or broken ones count as flat
constexpr float knee_reserve =
    0.02F;  // of the leg's length: the pelvis is lowered before a leg is straighter than that

/// How a foot is to be: model space.
struct FootGoal {
  glm::vec3 ankle{0.0F};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
  float planted = 0.0F;
};

/// How far the lowest point of the sole is below the ankle, along `normal`.
float clearance(const PlacedLeg& leg, const glm::quat& foot, const glm::vec3& normal) {
  return std::max(glm::dot(foot * -leg.sole[0], normal), glm::dot(foot * -leg.sole[1], normal));
}

Footing footing_under(const glm::vec3& ankle, const GroundContact& contact) {
  const bool usable = std::isfinite(contact.height) && is_finite(contact.normal) && contact.normal.y > steepest_ground;
  if (!usable) return {.place = {ankle.x, std::isfinite(contact.height) ? contact.height : 0.0F, ankle.z}};
  return {.place = {ankle.x, contact.height, ankle.z}, .normal = unit_or(contact.normal, up)};
}

Footing to_world(const JointMotion& model, const Footing& footing) {
  return {.place = model.position + model.rotation * footing.place, .normal = model.rotation * footing.normal};
}

Footing to_model(const JointMotion& model, const Footing& footing) {
  const glm::quat back = glm::conjugate(model.rotation);
  return {.place = back * (footing.place - model.position), .normal = back * footing.normal};
}

/// From the ankle to the ball of the foot, over the ground: the ball is what stands still while the heel comes and
/// goes.
glm::vec3 to_ball(const PlacedLeg& leg, const glm::quat& foot) {
  const glm::vec3 ball = foot * leg.sole[1];
  return {ball.x, 0.0F, ball.z};
}

Footing moved(const Footing& footing, const glm::vec3& place) {
  return {.place = {place.x, ground_height(footing, place.x, place.z), place.z}, .normal = footing.normal};
}

/// Metres from flat ground to the lowest point of the sole, as the pose has the foot.
float lift_of(const PlacedLeg& leg, const JointMotion& ankle) {
  return ankle.position.y - clearance(leg, ankle.rotation, up);
}

float planted_share(const FootPlacementJob& job, std::size_t i, const JointMotion& ankle) {
  if (job.planted[i] >= 0.0F) return job.planted[i];
  const float lift = lift_of(job.rig->legs[i], ankle);
  return std::clamp((job.options.up_above - lift) / (job.options.up_above - job.options.down_below), 0.0F, 1.0F);
}

FootGoal goal_of(const FootPlacementJob& job, std::size_t i, const JointMotion& ankle) {
  const PlacedLeg& leg = job.rig->legs[i];
  const float planted = planted_share(job, i, ankle);
  const Footing under_ankle = footing_under(ankle.position, job.contacts[i]);
  const Footing under_ball = moved(under_ankle, ankle.position + to_ball(leg, ankle.rotation));
  const Footing locked =
      to_model(job.model_in_world, step_foot_lock(job.state->feet[i], to_world(job.model_in_world, under_ball), planted,
                                                  job.options.lock, job.seconds));
  FootGoal goal{.planted = planted};
  goal.rotation = limited_turn(up, locked.normal, job.options.least_tilt_cosine) * ankle.rotation;
  const Footing footing = moved(locked, locked.place - to_ball(leg, goal.rotation));
  const float lift = lift_of(leg, ankle) * (1.0F - planted);
  const float above_ground = clearance(leg, goal.rotation, footing.normal) + lift;
  goal.ankle = footing.place + up * (above_ground / footing.normal.y);
  return goal;
}

/// How far the hip must come down for a leg to reach its goal without being straighter than it was or than the reserve.
float needed_drop(const TwoBoneLimb& limb, const ChainMotion& leg, const FootGoal& goal) {
  const glm::vec3 hip = leg[static_cast<std::size_t>(limb.upper)].position;
  const glm::vec3 ankle = leg[static_cast<std::size_t>(limb.end())].position;
  const float length = limb_length(limb, leg);
  const float reach = std::max(glm::distance(hip, ankle), length * (1.0F - knee_reserve));
  const glm::vec3 away = hip - goal.ankle;
  return away.y - std::sqrt(std::max(0.0F, reach * reach - away.x * away.x - away.z * away.z));
}

const JointMotion& ankle_motion(const FootPlacementRig& rig, const PosedLegs& legs, std::size_t leg) {
  return legs[leg][static_cast<std::size_t>(rig.legs[leg].limb.end())];
}

bool has_all_legs(const FootPlacementRig& rig, const PoseView& pose) {
  return std::all_of(rig.legs.begin(), rig.legs.begin() + rig.leg_count,
                     [&](const PlacedLeg& leg) { return is_within(leg.limb.chain, pose); });
}

/// Smoothed, but in time for a foot that lands.
DampedValue next_drop(const FootPlacementJob& job, float wanted) {
  const DampedValue& last = job.state->drop;
  DampedValue next = smooth_damp(last, wanted, job.options.drop_smooth_seconds, job.seconds);
  const float in_time = std::min(wanted - job.options.most_gap, last.value + job.options.fastest_drop * job.seconds);
  next.value = std::max(next.value, in_time);
  return next;
}

void lower_pelvis(const FootPlacementJob& job, float drop, PosedLegs& legs) {
  if (drop <= 0.0F) return;
  const FootPlacementRig& rig = *job.rig;
  shift_joint(rig.legs[0].limb.chain, rig.pelvis, -drop * up, job.pose, legs[0]);
  for (std::size_t i = 1; i < static_cast<std::size_t>(rig.leg_count); ++i) {
    follow_shift(rig.legs[i].limb.chain, rig.pelvis, -drop * up, legs[i]);
  }
}

float solve_leg(const FootPlacementJob& job, const TwoBoneLimb& limb, const FootGoal& goal, ChainMotion& leg) {
  return solve_two_bone_ik({.limb = &limb,
                            .pose = job.pose,
                            .target = goal.ankle,
                            .weight = job.weight,
                            .turn_end = true,
                            .end_rotation = goal.rotation},
                           leg);
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
                 glm::vec3(ball.x - ankle.x, sole_height - ankle.y, ball.z - ankle.z)}};
  }
  rig.pelvis = carrying_joint(rig);
  if (rig.pelvis < 0) {
    return Error{"no bone of skeleton '" + skeleton.name +
                 "' carries all its legs, so none can be lowered: parent them"};
  }
  return rig;
}

bool pose_legs(const FootPlacementRig& rig, const PoseView& pose, PosedLegs& legs) {
  if (!has_all_legs(rig, pose)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rig.leg_count); ++i) {
    pose_chain(rig.legs[i].limb.chain, pose, legs[i]);
  }
  return true;
}

glm::vec3 ankle_of(const FootPlacementRig& rig, const PosedLegs& legs, std::size_t leg) {
  return ankle_motion(rig, legs, leg).position;
}

FootPlacementResult place_feet(const FootPlacementJob& job) {
  PosedLegs legs;
  return pose_legs(*job.rig, job.pose, legs) ? place_feet(job, legs) : FootPlacementResult{};
}

FootPlacementResult place_feet(const FootPlacementJob& job, PosedLegs& legs) {
  const FootPlacementRig& rig = *job.rig;
  const auto count = static_cast<std::size_t>(rig.leg_count);
  assert(job.contacts.size() >= count && job.planted.size() >= count && job.seconds >= 0.0F);
  FootPlacementState& state = *job.state;
  if (job.weight <= 0.0F) {
    state = {};
    return {};
  }
  std::array<FootGoal, max_legs> goals;
  float wanted_drop = 0.0F;
  for (std::size_t i = 0; i < count; ++i) {
    goals[i] = goal_of(job, i, ankle_motion(rig, legs, i));
    wanted_drop = std::max(wanted_drop, goals[i].planted * needed_drop(rig.legs[i].limb, legs[i], goals[i]));
  }
  wanted_drop = std::min(wanted_drop, job.options.max_drop);
  state.drop = state.started ? next_drop(job, wanted_drop) : DampedValue{.value = wanted_drop};
  state.started = true;
  FootPlacementResult result{.drop = state.drop.value * job.weight};
  lower_pelvis(job, result.drop, legs);

  for (std::size_t i = 0; i < count; ++i) {
    result.missed_by[i] = solve_leg(job, rig.legs[i].limb, goals[i], legs[i]);
    const JointMotion& ankle = ankle_motion(rig, legs, i);
    const glm::vec3 ball = ankle.position + ankle.rotation * rig.legs[i].sole[1];
    measure_slide(state.feet[i], job.model_in_world.position + job.model_in_world.rotation * ball, goals[i].planted,
                  job.seconds);
  }
  return result;
}

}  // namespace throng::anim
