#include "app/commands/bench/joints.h"

#include <utility>

namespace throng::app {

std::unique_ptr<JointSubject> JointSubject::create(std::shared_ptr<const anim::Character> character,
                                                   const anim::SystemOptions& options,
                                                   std::span<const BenchAgent> agents, const BenchPalettes& palettes,
                                                   const anim::JointList& list, anim::JointFormat format) {
  constexpr std::size_t line_bytes = 64;
  const std::size_t lines = (list.size() * anim::joint_bytes(format) + line_bytes - 1) / line_bytes;
  const std::size_t stride = (lines | 1U) * line_bytes;
  auto made = std::make_unique<JointSubject>();
  made->memory_ = anim::allocate_aligned(stride * agents.size());
  auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
  if (!subject || !subject->system().characters().write_joints(list, format)) return nullptr;
  subject->write_joints(made->memory_.get(), stride);
  made->subject_ = std::make_unique<SystemSubject>(std::move(*subject));
  return made;
}

anim::JointList three_joints(const anim::Skeleton& skeleton) {
  const int bones = skeleton.bone_count();
  return {{.bone = bones / 2}, {.bone = bones * 3 / 4}, {.bone = bones - 1}};
}

}  // namespace throng::app
