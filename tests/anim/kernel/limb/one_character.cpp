#include "tests/anim/kernel/limb/one_character.h"

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

float place_feet(const FootPlacementJob& job) {
  best_kernels().place_feet({&job, 1});
  return job.body->drop.value * job.weight;
}

float solve_two_bone_ik(const TwoBoneIkJob& job) {
  float missed_by = 0.0F;
  best_kernels().two_bone_ik({&job, 1}, &missed_by);
  return missed_by;
}

float look_at(const LookAtJob& job) {
  best_kernels().look_at({&job, 1});
  return job.state->remaining;
}

}  // namespace throng::anim
