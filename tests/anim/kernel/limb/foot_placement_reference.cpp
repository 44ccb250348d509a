#include "tests/anim/kernel/limb/foot_placement_reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"
#include "tests/anim/kernel/limb/foot_lock_reference.h"
#include "tests/anim/kernel/limb/parent_rotation.h"
#include "tests/anim/kernel/limb/two_bone_ik_reference.h"

namespace throng::anim {

glm::vec3 under_toes(const PlacedLeg& leg, const glm::quat& foot, const glm::vec3& normal) {
  return foot * leg.sole[1] - leg.ball_height * normal;
}

namespace {

constexpr glm::vec3 upwards{0.0F, 1.0F, 0.0F};
constexpr float steepest_ground = 0.2F;  // least y of a normal; steeper or broken ones count as flat

/// How a foot is to be: model space.
struct FootGoal {
  glm::vec3 ankle{0.0F};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
  float planted = 0.0F;
  float drop = 0.0F;   // metres that the hip must come down for it
  float steps = 0.0F;  // metres that it is lifted on its way back
};

/// What a leg reaches, model space.
struct LegReach {
  glm::vec3 hip{0.0F};
  float length = 0.0F;
  float farthest = 0.0F;  // from the hip to the ankle
};

/// How far the lowest point of the sole is below the ankle, along `normal`.
float clearance(const PlacedLeg& leg, const glm::quat& foot, const glm::vec3& normal) {
  return -std::min(glm::dot(foot * leg.sole[0], normal), glm::dot(under_toes(leg, foot, normal), normal));
}

/// Returns how high a foot in the air is at least, where the host says that it is there.
float least_air(const PlacedFoot& foot, const LegReach& reach) {
  return foot.planted >= 0.0F ? foot_clearance * reach.length : -1e9F;
}

Footing to_world(const JointMotion& model, const Footing& footing) {
  return {.place = model.position + model.rotation * footing.place, .normal = model.rotation * footing.normal};
}

Footing to_model(const JointMotion& model, const Footing& footing) {
  const glm::quat back = glm::conjugate(model.rotation);
  return {.place = back * (footing.place - model.position), .normal = back * footing.normal};
}

/// The plane that the foot is to stand on, model space: at the place given, or level where that is steep or broken.
Footing ground_of(const FootPlacementJob& job, const PlacedFoot& foot) {
  const JointMotion& model = job.body->model_in_world;
  const glm::vec3 normal = unit_or(foot.ground.normal, upwards);
  if (is_place(foot.ground.place) && normal.y > steepest_ground) return to_model(model, {foot.ground.place, normal});
  const bool has_height = std::fabs(foot.ground.place.y) < farthest_place;
  return {.place = {0.0F, has_height ? foot.ground.place.y - model.position.y : 0.0F, 0.0F}};
}

/// From the ankle to the ball of the foot, over the ground: the ball is what stands still while the heel comes and
/// goes.
glm::vec3 to_ball(const PlacedLeg& leg, const glm::quat& foot, const glm::vec3& normal) {
  const glm::vec3 ball = under_toes(leg, foot, normal);
  return {ball.x, 0.0F, ball.z};
}

Footing moved(const Footing& footing, const glm::vec3& place) {
  return {.place = {place.x, ground_height(footing, place.x, place.z), place.z}, .normal = footing.normal};
}

/// Metres from flat ground to the lowest point of the sole, as the pose has the foot.
float lift_of(const PlacedLeg& leg, const JointMotion& ankle) {
  return ankle.position.y - clearance(leg, ankle.rotation, upwards);
}

float planted_share(const PlacedFoot& foot, const FootPlacementOptions& options, float lift) {
  if (foot.planted >= 0.0F) return foot.planted;
  return std::clamp((options.up_above - lift) / (options.up_above - options.down_below), 0.0F, 1.0F);
}

LegReach reach_of(const TwoBoneLimb& limb, const ChainMotion& leg) {
  const glm::vec3 hip = leg[static_cast<std::size_t>(limb.upper)].position;
  const glm::vec3 ankle = leg[static_cast<std::size_t>(limb.end())].position;
  const float length = limb_length(limb, leg);
  return {hip, length, std::max(glm::distance(hip, ankle), length * (1.0F - knee_reserve))};
}

/// How far the hip must come down for a leg to reach an ankle without being straighter than it was or than the reserve.
float needed_drop(const LegReach& leg, const glm::vec3& ankle) {
  const glm::vec3 away = leg.hip - ankle;
  return away.y - std::sqrt(std::max(0.0F, leg.farthest * leg.farthest - away.x * away.x - away.z * away.z));
}

/// The share of the way from one ankle to another that a leg reaches when its hip is lowered by `drop`.
float reached_share(const LegReach& leg, float drop, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 start = from - (leg.hip - drop * upwards);
  const glm::vec3 way = to - from;
  const float square = glm::dot(way, way);
  const float along = glm::dot(start, way);
  const float room = std::max(0.0F, leg.farthest * leg.farthest - glm::dot(start, start));
  return std::min((std::sqrt(along * along + square * room) - along) / std::max(square, 1e-12F), 1.0F);
}

FootGoal goal_of(const FootPlacementJob& job, const PlacedLeg& leg, const LegReach& reach, const JointMotion& ankle,
                 PlacedFoot& foot) {
  const JointMotion& model = job.body->model_in_world;
  const FootPlacementOptions& options = job.body->options;
  const float planted = planted_share(foot, options, lift_of(leg, ankle));
  const Footing under_ball = moved(ground_of(job, foot), ankle.position + to_ball(leg, ankle.rotation, upwards));
  const Footing locked = to_model(
      model, step_foot_lock(foot.lock, to_world(model, under_ball), planted, options.lock, job.seconds, foot.reached));
  const float clear = least_air(foot, reach);
  FootGoal goal{.planted = planted, .steps = rise_of_step(foot.lock, planted, options.lock, clear)};
  goal.rotation = limited_turn(upwards, locked.normal, options.least_tilt_cosine) * ankle.rotation;
  const float lift = std::max(lift_of(leg, ankle), clear) * (1.0F - planted) + goal.steps;
  const float above_ground = clearance(leg, goal.rotation, locked.normal) + lift;
  const auto ankle_over = [&](const glm::vec3& ball) {
    return moved(locked, ball - to_ball(leg, goal.rotation, locked.normal)).place +
           upwards * (above_ground / locked.normal.y);
  };
  const glm::vec3 held = ankle_over(locked.place);
  const glm::vec3 carried = ankle_over(under_ball.place);
  const float reserve = foot.planted >= 0.0F ? told_lock_reserve : lock_reserve;
  const float most_drop = std::max(needed_drop(reach, carried), 0.0F) + reserve * reach.length;
  const bool is_beyond = needed_drop(reach, held) > most_drop;
  foot.reached = is_beyond ? reached_share(reach, most_drop, carried, held) : 1.0F;
  goal.drop = std::min(needed_drop(reach, held), most_drop);
  goal.ankle = is_beyond ? carried + foot.reached * (held - carried) : held;
  return goal;
}

DampedValue next_drop(const FootPlacementJob& job, float wanted) {
  const FootPlacementOptions& options = job.body->options;
  const DampedValue& last = job.body->drop;
  if (!job.body->started) return {.value = wanted};
  DampedValue next = smooth_damp(last, wanted, options.drop_smooth_seconds, job.seconds);
  const float in_time = std::min(wanted - options.most_gap, last.value + options.fastest_drop * job.seconds);
  next.value = std::max(next.value, in_time);
  return next;
}

void lower_pelvis(const FootPlacementJob& job, float drop) {
  if (drop <= 0.0F) return;
  ChainMotion motions;
  pose_chain(job.rig->legs[0].limb.chain, job.pose, motions);
  const int bone = job.rig->pelvis_bone();
  const glm::vec3 shift = glm::conjugate(parent_rotation(motions, job.rig->pelvis)) * (-drop * upwards);
  job.pose.set_position(bone, job.pose.position(bone) + shift);
}

}  // namespace

float place_feet_by_definition(const FootPlacementJob& job) {
  const FootPlacementRig& rig = *job.rig;
  PlacedBody& body = *job.body;
  if (!has_all_legs(rig, job.pose)) {
    forget_feet(job);
    return 0.0F;
  }
  std::array<FootGoal, max_legs> goals;
  float wanted_drop = 0.0F;
  ChainMotion chain;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rig.leg_count); ++i) {
    const TwoBoneLimb& limb = rig.legs[i].limb;
    pose_chain(limb.chain, job.pose, chain);
    const JointMotion& ankle = chain[static_cast<std::size_t>(limb.end())];
    job.feet[i].ankle = ankle.position;
    goals[i] = goal_of(job, rig.legs[i], reach_of(limb, chain), ankle, job.feet[i]);
    wanted_drop = std::max(wanted_drop, goals[i].planted * goals[i].drop);
  }
  if (job.weight <= 0.0F) {
    forget_feet(job);
    return 0.0F;
  }
  body.drop = next_drop(job, std::min(wanted_drop, body.options.max_drop));
  body.started = true;
  lower_pelvis(job, body.drop.value * job.weight);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rig.leg_count); ++i) {
    const TwoBoneLimb& limb = rig.legs[i].limb;
    job.feet[i].missed_by = two_bone_ik_by_definition({.limb = &limb,
                                                       .pose = job.pose,
                                                       .target = goals[i].ankle,
                                                       .weight = job.weight,
                                                       .turn_end = true,
                                                       .end_rotation = goals[i].rotation});
    pose_chain(limb.chain, job.pose, chain);
    const JointMotion& ankle = chain[static_cast<std::size_t>(limb.end())];
    const glm::vec3 ball = ankle.position + ankle.rotation * rig.legs[i].sole[1];
    measure_slide(job.feet[i].lock, body.model_in_world.position + body.model_in_world.rotation * ball,
                  goals[i].steps > 0.0F ? 0.0F : goals[i].planted, job.seconds);
  }
  return body.drop.value * job.weight;
}

}  // namespace throng::anim
