#include "engine/crowd/exact_poses.h"

namespace throng {

void ExactPoses::reset(std::size_t agents, std::uint64_t last_frame) {
  give_back(last_frame);
  poses_.assign(agents, {});
}

void ExactPoses::give_back(std::uint64_t last_frame) {
  for (const anim::ExactPose& each : posed_) slots_->retire(poses_[each.agent.number].to, last_frame);
  posed_.clear();
}

void ExactPoses::add(std::uint32_t agent, const ShownPose& shown, std::uint32_t entries) {
  poses_[agent] = shown;
  if (entries == 0) return;
  const PaletteSlot slot = slots_->acquire(anim::palette_stride(entries, PaletteFormat::matrices));
  if (!slot.valid()) return;
  poses_[agent] = {.from = slot, .to = slot};
  posed_.push_back({.agent = {agent}, .palette = reinterpret_cast<anim::PaletteMatrix*>(slots_->memory(slot))});
}

void ExactPoses::pose(anim::AnimationSystem& system) {
  if (!posed_.empty()) system.pose_exactly(posed_);
}

}  // namespace throng
