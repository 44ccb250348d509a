#include "engine/anim/run/store/strip_joints.h"

#include <algorithm>

namespace throng::anim {

StripJoints::StripJoints(const UpdateContext& context, const ModelScratch& scratch, std::span<const AgentWork> strip,
                         int width, float* unseen) {
  if (context.joint_programs.empty() || context.joints_to.empty()) return;
  std::ranges::fill(scratch.joints, unseen);
  bool wanted = false;
  for (std::size_t i = 0; i < strip.size(); ++i) {
    const PaletteDestination to = context.joints_to[strip[i].agent];
    if (to == nullptr) continue;
    scratch.joints[i] = reinterpret_cast<float*>(to.memory());
    wanted = true;
  }
  if (!wanted) return;
  model_joints_ = context.assets.kernels->model_joints;
  job_ = {.program = &context.joint_programs[strip.front().level],
          .width = width,
          .carry = scratch.joint_carry.data(),
          .branch_slots = scratch.joint_branches.data(),
          .to = scratch.joints.data()};
}

void StripJoints::write(const StripPacket& about) {
  if (!needs(about.packet)) return;
  job_.packet = about.packet;
  job_.local = about.local;
  job_.displaced = about.displaced;
  model_joints_(job_);
}

}  // namespace throng::anim
