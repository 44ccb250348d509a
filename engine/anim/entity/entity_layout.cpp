#include "engine/anim/entity/entity_layout.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace throng::anim {
namespace {

bool is_one_in_identity(int component) { return component == 3 || component >= rigid_components; }

void fill_with_identity(float* pose, int bone_count, int components) {
  for (int packet = 0; packet < packets_for(bone_count); ++packet) {
    for (int component = 0; component < components; ++component, pose += packet_bones) {
      std::fill_n(pose, packet_bones, is_one_in_identity(component) ? 1.0F : 0.0F);
    }
  }
}

}  // namespace

EntityLayout entity_layout(const EntityKind& kind, Residency residency, int bone_count, int components) {
  const bool resident = residency == Residency::resident || kind.keeps_transforms;
  const std::size_t transforms = resident ? pose_bytes(bone_count, components) : 0;
  const std::size_t for_pose = kind.private_bytes_for == nullptr ? 0 : kind.private_bytes_for(bone_count, components);
  const std::size_t private_part = kind.private_bytes + for_pose;
  const std::size_t private_offset = entity_header_bytes + transforms;
  const std::size_t total = (private_offset + private_part + 63) / 64 * 64;
  return {.kind = &kind,
          .total_size = static_cast<std::uint32_t>(total),
          .transforms_offset = resident ? static_cast<std::uint32_t>(entity_header_bytes) : 0,
          .private_offset = static_cast<std::uint32_t>(private_offset)};
}

void initialise_state(AnimationStateHeader& state, const EntityLayout& layout, int bone_count, int components) {
  state.type = layout.kind->type;
  state.total_size = layout.total_size;
  state.transforms_offset = layout.transforms_offset;
  state.bone_count = static_cast<std::uint16_t>(bone_count);
  state.components = static_cast<std::uint16_t>(components);
  state.priority = highest_priority;
  state.absolute_rotation[3] = 1.0F;
  if (layout.is_resident()) fill_with_identity(transforms_of(state), bone_count, components);
}

void convert_residency(const std::byte* from, std::byte* to, const EntityLayout& from_layout,
                       const EntityLayout& to_layout) {
  assert(from_layout.private_bytes() == to_layout.private_bytes());
  if (from_layout.total_size == to_layout.total_size) {
    std::memcpy(to, from, from_layout.total_size);
    return;
  }
  std::memcpy(to, from, entity_header_bytes);
  std::memcpy(to + to_layout.private_offset, from + from_layout.private_offset, from_layout.private_bytes());
  auto& state = *reinterpret_cast<AnimationStateHeader*>(to);
  state.total_size = to_layout.total_size;
  state.transforms_offset = to_layout.transforms_offset;
}

}  // namespace throng::anim
