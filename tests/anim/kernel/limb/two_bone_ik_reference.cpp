#include "tests/anim/kernel/limb/two_bone_ik_reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "engine/anim/kernel/lanes/rotations.h"
#include "tests/anim/kernel/limb/parent_rotation.h"

namespace throng::anim {

namespace {

struct LimbPlaces {
  glm::vec3 upper;
  glm::vec3 middle;
  glm::vec3 end;
};

LimbPlaces places_of(const TwoBoneLimb& limb, std::span<const JointMotion> motions) {
  const auto at = [&](int joint) { return motions[static_cast<std::size_t>(joint)].position; };
  return {at(limb.upper), at(limb.middle), at(limb.end())};
}

/// The rotation that brings one direction and the bend normal beside it to another pair.
glm::quat turn_pair(const glm::vec3& from, const glm::vec3& from_normal, const glm::vec3& to,
                    const glm::vec3& to_normal) {
  const auto frame = [](const glm::vec3& direction, const glm::vec3& normal) {
    const glm::vec3 across = unit_or_perpendicular(perpendicular_part(normal, direction), direction);
    return glm::mat3(direction, across, glm::cross(direction, across));
  };
  return glm::normalize(glm::quat_cast(frame(to, to_normal) * glm::transpose(frame(from, from_normal))));
}

/// Distance at which the end is put for a target this far away: eases out towards the full length.
float soft_reach(float distance, float length, float softness, float posed_distance) {
  const float easing_from = std::max(length * (1.0F - softness), std::min(posed_distance, length));
  const float room = length - easing_from;
  const float beyond = distance - easing_from;
  if (beyond <= 0.0F) return distance;
  return easing_from + (room > 0.0F ? room * beyond / (room + beyond) : 0.0F);
}

/// The limb as it is to be: model-space turns of the upper and the middle joint.
struct LimbTurns {
  glm::quat upper;
  glm::quat middle;
};

LimbTurns solve(const TwoBoneIkJob& job, const LimbPlaces& posed, const glm::vec3& hinge) {
  const float first_length = glm::distance(posed.upper, posed.middle);
  const float second_length = glm::distance(posed.middle, posed.end);
  const float length = first_length + second_length;
  const glm::vec3 first = (posed.middle - posed.upper) / first_length;
  const glm::vec3 second = (posed.end - posed.middle) / second_length;
  const glm::vec3 posed_reach = unit_or(posed.end - posed.upper, first);
  const glm::vec3 reach = unit_or(job.target - posed.upper, posed_reach);

  const float nearest = std::max(std::fabs(first_length - second_length), 1e-4F * length);
  const float wanted =
      soft_reach(glm::distance(posed.upper, job.target), length, job.softness, glm::distance(posed.upper, posed.end));
  const float distance = std::clamp(wanted, nearest, length);

  const glm::vec3 normal = bend_normal(first, second, hinge);
  const glm::vec3 kept_normal = shortest_turn(posed_reach, reach) * normal;
  const glm::vec3 kept_out = unit_or_perpendicular(glm::cross(reach, kept_normal), reach);
  const glm::vec3 pole_out = perpendicular_part(unit_or(job.pole, glm::vec3(0.0F)), reach);
  const glm::vec3 out = glm::length(pole_out) > 1e-3F ? unit_or(pole_out, kept_out) : kept_out;

  // Law of cosines: the middle is `along` the way to the target and `aside` of it.
  const float along = std::clamp((distance * distance + (first_length - second_length) * length) / (2.0F * distance),
                                 -first_length, first_length);
  const float aside = std::sqrt(std::max(0.0F, (first_length - along) * (first_length + along)));
  const glm::vec3 new_normal = glm::cross(out, reach);
  const glm::vec3 new_first = unit_or(reach * along + out * aside, reach);
  const glm::vec3 new_second = unit_or(reach * distance - new_first * first_length, reach);
  return {.upper = turn_pair(first, normal, new_first, new_normal),
          .middle = turn_pair(second, normal, new_second, new_normal)};
}

/// What a joint is to be, model space.
struct JointTurn {
  int joint;  ///< place in the chain
  glm::quat rotation;
};

/// Writes the local rotations that give joints these in model space, one or more, in ascending order; what is below
/// them follows, in `motions` too.
void turn_joints(const JointChain& chain, std::span<const JointTurn> turns, const PoseView& pose,
                 std::span<JointMotion> motions) {
  for (const JointTurn& turn : turns) {
    const glm::quat local = glm::conjugate(parent_rotation(motions, turn.joint)) * turn.rotation;
    pose.set_rotation(chain.bones[static_cast<std::size_t>(turn.joint)], glm::normalize(local));
    pose_chain(chain, pose, motions, turn.joint);
  }
}

/// Turns joints part of the way to where `solved` has them, each seen from its parent.
void blend_joints(const TwoBoneIkJob& job, std::span<const JointTurn> turns, std::span<const JointMotion> posed,
                  std::span<const JointMotion> solved) {
  for (const JointTurn& turn : turns) {
    const auto local = [&turn](std::span<const JointMotion> motions) {
      return glm::conjugate(parent_rotation(motions, turn.joint)) *
             motions[static_cast<std::size_t>(turn.joint)].rotation;
    };
    const int bone = job.limb->chain.bones[static_cast<std::size_t>(turn.joint)];
    job.pose.set_rotation(bone, mix_rotations(local(posed), local(solved), job.weight));
  }
}

}  // namespace

float limb_length(const TwoBoneLimb& limb, std::span<const JointMotion> motions) {
  const LimbPlaces places = places_of(limb, motions);
  return glm::distance(places.upper, places.middle) + glm::distance(places.middle, places.end);
}

float two_bone_ik_by_definition(const TwoBoneIkJob& job) {
  if (!is_within(job.limb->chain, job.pose)) return 0.0F;
  ChainMotion motions;
  pose_chain(job.limb->chain, job.pose, motions);
  return two_bone_ik_by_definition(job, motions);
}

float two_bone_ik_by_definition(const TwoBoneIkJob& job, std::span<JointMotion> motions) {
  const TwoBoneLimb& limb = *job.limb;
  if (!is_place(job.target)) return 0.0F;
  const LimbPlaces places = places_of(limb, motions);
  const bool has_length = glm::distance(places.upper, places.middle) > shortest_limb_bone &&
                          glm::distance(places.middle, places.end) > shortest_limb_bone;
  if (job.weight <= 0.0F || !has_length) return glm::distance(places.end, job.target);

  const auto rotation = [&motions](int joint) { return motions[static_cast<std::size_t>(joint)].rotation; };
  const LimbTurns limb_turns = solve(job, places, rotation(limb.upper) * limb.hinge);
  const std::array<JointTurn, 3> all_turns = {{{limb.upper, limb_turns.upper * rotation(limb.upper)},
                                               {limb.middle, limb_turns.middle * rotation(limb.middle)},
                                               {limb.end(), job.end_rotation}}};
  const std::span turns = std::span(all_turns).first(job.turn_end ? 3 : 2);
  ChainMotion posed;
  if (job.weight < 1.0F) {
    std::ranges::copy(motions.first(static_cast<std::size_t>(limb.chain.count)), std::span<JointMotion>(posed).begin());
  }
  turn_joints(limb.chain, turns, job.pose, motions);
  if (job.weight < 1.0F) {
    blend_joints(job, turns, posed, motions);
    pose_chain(limb.chain, job.pose, motions, limb.upper);
  }
  return glm::distance(motions[static_cast<std::size_t>(limb.end())].position, job.target);
}

}  // namespace throng::anim
