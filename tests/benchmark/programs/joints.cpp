#include "tests/benchmark/programs/joints.h"

#include <utility>

namespace throng::app {

std::unique_ptr<JointSubject> JointSubject::create(std::shared_ptr<const anim::Character> character,
                                                   const anim::SystemOptions& options,
                                                   std::span<const BenchAgent> agents, const BenchPalettes& palettes,
                                                   const anim::JointList& list, JointFormat format) {
  constexpr std::size_t line_bytes = 64;
  const std::size_t lines = (list.size() * anim::joint_bytes(format) + line_bytes - 1) / line_bytes;
  const std::size_t stride = (lines | 1U) * line_bytes;
  auto made = std::make_unique<JointSubject>();
  made->memory_ = anim::allocate_aligned(stride * agents.size());
  auto subject = SystemSubject::create(std::move(character), options, agents, palettes);
  if (!subject || !subject->system().characters().write_joints(list, format)) return nullptr;
  for (std::size_t agent = 0; agent < agents.size(); ++agent) {
    subject->updates()[agent].palette = nullptr;
    subject->updates()[agent].joints = made->memory_.get() + agent * stride;
  }
  made->subject_ = std::make_unique<SystemSubject>(std::move(*subject));
  return made;
}

anim::JointList three_joints(const anim::Skeleton& skeleton) {
  const int bones = skeleton.bone_count();
  return {{.bone = bones / 2}, {.bone = bones * 3 / 4}, {.bone = bones - 1}};
}

}  // namespace throng::app
