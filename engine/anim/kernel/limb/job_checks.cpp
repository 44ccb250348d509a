#include "engine/anim/kernel/lanes/job_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/anim/kernel/lanes/rotations.h"
#include "engine/anim/kernel/limb/chain_reach.h"
#include "engine/anim/kernel/limb/foot_placement.h"
#include "engine/anim/kernel/limb/look_at.h"
#include "engine/anim/kernel/limb/spring_bones.h"
#include "engine/anim/kernel/limb/two_bone_ik.h"

namespace throng::anim {
namespace {

constexpr float half_turn = std::numbers::pi_v<float>;
constexpr float farthest_from_unit = 1e-3F;  // as pose_chain allows

bool is_unit(const glm::quat& rotation) {
  return std::abs(glm::dot(rotation, rotation) - 1.0F) < 2.0F * farthest_from_unit;
}

bool is_rigid(const PoseView& pose) { return is_valid(pose) && pose.components == rigid_components; }

bool is_chain(const JointChain& chain) { return chain.count >= 1 && chain.count <= JointChain::max_joints; }

bool is_limb(const TwoBoneLimb& limb) {
  return is_chain(limb.chain) && limb.upper >= 0 && limb.upper < limb.middle && limb.middle < limb.end();
}

bool is_rig(const LookAtRig& rig) {
  return is_chain(rig.chain) && rig.joint_count >= 1 && rig.joint_count <= max_look_joints;
}

template <class Job, class RigOf>
bool are_of_one_rig(std::span<const Job> jobs, RigOf rig_of) {
  return std::ranges::all_of(jobs, [&](const Job& job) { return is_valid(job) && rig_of(job) == rig_of(jobs[0]); });
}

}  // namespace

bool is_valid(const LookAtLimits& limits) {
  const auto is_below = [](float angle, float most) { return angle >= 0.0F && angle < most; };
  return is_below(limits.yaw, half_turn) && is_below(limits.pitch_up, half_turn / 2) &&
         is_below(limits.pitch_down, half_turn / 2) && is_not_negative(limits.smooth_seconds);
}

bool is_valid(const FootPlacementOptions& options) {
  return options.down_below < options.up_above && is_not_negative(options.max_drop) &&
         is_not_negative(options.drop_smooth_seconds) && is_not_negative(options.most_gap) &&
         is_not_negative(options.fastest_drop) && is_share(options.least_tilt_cosine) &&
         is_not_negative(options.lock.release_seconds) && is_not_negative(options.lock.farthest);
}

bool is_valid(const Footing& footing) {
  constexpr float off_by = 0.02F;  // of the square of a length
  const float square = glm::dot(footing.normal, footing.normal);
  return is_place(footing.place) && std::abs(square - 1.0F) < off_by && footing.normal.y > 0.0F;
}

bool is_valid(const JointMotion& motion) { return is_place(motion.position) && is_unit(motion.rotation); }

bool is_valid(const LookAtJob& job) {
  return job.rig != nullptr && is_rig(*job.rig) && is_aligned(job.state, alignof(LookAtState)) && is_rigid(job.pose) &&
         is_not_negative(job.seconds) && is_valid(job.limits) && is_share(job.weight);
}

bool is_valid(const TwoBoneIkJob& job) {
  return job.limb != nullptr && is_limb(*job.limb) && is_rigid(job.pose) && is_share(job.weight) &&
         job.softness >= 0.0F && job.softness <= most_limb_softness && (!job.turn_end || is_unit(job.end_rotation));
}

bool is_valid(const FootPlacementJob& job) {
  if (job.rig == nullptr || job.rig->leg_count < 1 || job.rig->leg_count > max_legs) return false;
  if (!is_aligned(job.body, alignof(PlacedBody)) || !is_aligned(job.feet, alignof(PlacedFoot))) return false;
  if (!is_rigid(job.pose) || !is_unit(job.body->model_in_world.rotation)) return false;
  const bool lowers = !has_all_legs(*job.rig, job.pose) || job.pose.displaces(job.rig->pelvis_bone());
  return lowers && is_valid(job.body->options) && is_not_negative(job.seconds) && is_share(job.weight);
}

bool is_valid(const SpringBonesJob& job) {
  if (job.rig == nullptr || job.body == nullptr || !is_rigid(job.pose)) return false;
  return job.joints.size() == job.rig->joints.size() &&
         job.carriers.size() == job.rig->chains.size() + job.rig->colliders.size() && is_not_negative(job.seconds) &&
         is_share(job.weight);
}

bool is_valid(const ChainReachJob& job) {
  return job.reach != nullptr && is_chain(job.reach->chain) && job.reach->first >= 0 &&
         job.reach->first < job.reach->chain.tip() && is_rigid(job.pose) && is_share(job.weight) &&
         job.iterations >= 1 && job.iterations <= most_reach_iterations && is_not_negative(job.tolerance);
}

bool is_valid(std::span<const LookAtJob> jobs) {
  return jobs.size() <= std::size_t{widest_strip} && are_of_one_rig(jobs, [](const LookAtJob& job) { return job.rig; });
}

bool is_valid(std::span<const TwoBoneIkJob> jobs) {
  return are_of_one_rig(jobs, [](const TwoBoneIkJob& job) { return job.limb; });
}

bool is_valid(std::span<const FootPlacementJob> jobs) {
  return are_of_one_rig(jobs, [](const FootPlacementJob& job) { return job.rig; });
}

}  // namespace throng::anim
