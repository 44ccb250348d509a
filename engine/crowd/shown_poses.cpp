#include "engine/crowd/shown_poses.h"

namespace throng {

void ShownPoses::retire_from(ShownPose& pose, std::uint64_t last_frame) {
  if (pose.from.valid() && pose.from.first_line != pose.to.first_line) slots_->retire(pose.from, last_frame);
}

void ShownPoses::hide(ShownPose& pose, std::uint64_t last_frame) {
  retire_from(pose, last_frame);
  if (pose.to.valid()) slots_->retire(pose.to, last_frame);
  pose = {};
}

void ShownPoses::reset(std::size_t agents, std::uint64_t last_frame) {
  for (ShownPose& pose : poses_) hide(pose, last_frame);
  poses_.assign(agents, {});
  shown_.clear();
  shown_.reserve(agents);
  gone_.set_aside(agents);
  out_of_memory_ = false;
}

void ShownPoses::hide_unseen(const anim::LevelOfDetail& lod, std::uint64_t last_frame, Executor& executor, int jobs) {
  const auto is_gone = [&](std::size_t i, std::uint32_t& listed) { return !lod.is_visible(listed = shown_[i]); };
  for (const std::uint32_t agent : gone_.gather(shown_.size(), executor, jobs, is_gone)) {
    hide(poses_[agent], last_frame);
  }
  const std::span<const anim::VisibleAgent> visible = lod.selection().visible;
  shown_.resize(visible.size());
  visit_in_tiles(visible.size(), executor, jobs, [&](std::size_t i) { shown_[i] = visible[i].agent; });
}

std::byte* ShownPoses::show(const NewPose& next, std::uint32_t now, std::uint64_t last_frame) {
  ShownPose& pose = poses_[next.agent];
  const std::size_t bytes = anim::palette_stride(next.entries, next.format);
  PaletteSlot slot = slots_->acquire(bytes, pose.to.page);
  // Its page is full: the agent moves to another.
  if (!slot.valid() && pose.to.valid()) slot = slots_->acquire(bytes);
  if (!slot.valid()) {
    out_of_memory_ = true;
    hide(pose, last_frame);
    return nullptr;
  }
  retire_from(pose, last_frame);
  const bool blends = next.time != now && pose.to.valid() && pose.to.page == slot.page;
  if (!blends && pose.to.valid()) slots_->retire(pose.to, last_frame);
  pose = {.from = blends ? pose.to : slot,
          .to = slot,
          .from_level = blends ? pose.to_level : next.level,
          .to_level = next.level,
          .from_format = blends ? pose.to_format : next.format,
          .to_format = next.format,
          .from_time = blends ? pose.to_time : now,
          .to_time = blends ? next.time : now};
  return slots_->memory(slot);
}

}  // namespace throng
