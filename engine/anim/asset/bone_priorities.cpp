#include "engine/anim/asset/bone_priorities.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {

namespace {

constexpr std::uint16_t all_lanes = 0xFFFF;

StateTransform still_state(const Skeleton& skeleton, int bone) {
  const bool stands_at_rest = !skeleton.rigid && bone < skeleton.bone_count();
  return stands_at_rest ? rest_transform(skeleton.bones[static_cast<std::size_t>(bone)]) : StateTransform{};
}

/// Returns the bits of the lanes that hold no bone.
std::uint16_t padding_lanes(int bone_count, int packet) {
  const int bones = std::min(bone_count - packet * packet_bones, packet_bones);
  return static_cast<std::uint16_t>(all_lanes << bones);
}

}  // namespace

BoneSelection::BoneSelection(const Skeleton& skeleton, std::span<const std::uint8_t> priorities, std::uint8_t least)
    : components_(skeleton.components()),
      lanes_(static_cast<std::size_t>(packets_for(skeleton.bone_count()))),
      still_(allocate_aligned(pose_bytes(skeleton.bone_count(), components_))) {
  assert(priorities.size() == skeleton.bones.size());
  for (int packet = 0; packet < packets(); ++packet) {
    unsigned bits = 0;
    for (int lane = 0; lane < packet_bones; ++lane) {
      const int bone = packet * packet_bones + lane;
      store_state(still_state(skeleton, bone), bone, components_, reinterpret_cast<float*>(still_.get()));
      if (bone >= skeleton.bone_count() || priorities[static_cast<std::size_t>(bone)] < least) continue;
      bits |= 1U << static_cast<unsigned>(lane);
    }
    if (bits != 0) bits |= padding_lanes(skeleton.bone_count(), packet);
    lanes_[static_cast<std::size_t>(packet)] = static_cast<std::uint16_t>(bits);
  }
}

const float* BoneSelection::still(int packet) const {
  assert(packet >= 0 && packet < packets());
  return reinterpret_cast<const float*>(still_.get()) +
         static_cast<std::ptrdiff_t>(packet) * components_ * packet_bones;
}

void apply_bone_priorities(const BoneSelection& bones, int packet, float* pose) {
  const unsigned lanes = bones.lanes(packet);
  if (lanes == all_lanes) return;
  const float* still = bones.still(packet);
  for (int component = 0; component < bones.components(); ++component) {
    for (int lane = 0; lane < packet_bones; ++lane) {
      const int place = component * packet_bones + lane;
      if ((lanes >> static_cast<unsigned>(lane) & 1U) == 0) pose[place] = still[place];
    }
  }
}

}  // namespace throng::anim
