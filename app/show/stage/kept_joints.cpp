#include "app/show/stage/kept_joints.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/anim/asset/joint_list.h"

namespace throng::app {

Status KeptJoints::begin(anim::AnimationSystem& system, std::span<const CharacterSource> characters) {
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < characters.size(); ++i) {
    const anim::JointList list = anim::all_joints(characters[i].character->skeleton);
    const CharacterId id{i};
    if (Status set = system.characters().write_joints(list, JointFormat::matrices, id); !set) return set;
    most = std::max(most, system.characters().joint_bytes(id));
  }
  stride_ = (most + anim::block_alignment - 1) / anim::block_alignment * anim::block_alignment;
  return Done{};
}

void KeptJoints::make_room(std::size_t agents) {
  if (agents <= agents_ || stride_ == 0) return;
  anim::AlignedBytes larger = anim::allocate_aligned(agents * stride_);
  if (agents_ > 0) std::memcpy(larger.get(), memory_.get(), agents_ * stride_);
  memory_ = std::move(larger);
  agents_ = agents;
}

}  // namespace throng::app
