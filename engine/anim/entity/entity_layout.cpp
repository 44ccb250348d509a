#include "engine/anim/entity/entity_layout.h"

#include <cassert>
#include <cstring>

#include "engine/anim/kernel/keyframe_player.h"

namespace throng::anim {

EntityLayout entity_layout(EntityType type, Residency residency, int bone_count, int components) {
  const bool resident = residency == Residency::resident;
  const std::size_t transforms = resident ? pose_bytes(bone_count, components) : 0;
  const std::size_t interpolations =
      type == EntityType::keyframe_player ? interpolation_bytes(bone_count, components) : 0;
  const std::size_t private_offset = entity_header_bytes + transforms;
  const std::size_t total = (private_offset + interpolations + 63) / 64 * 64;
  return {.total_size = static_cast<std::uint32_t>(total),
          .transforms_offset = resident ? static_cast<std::uint32_t>(entity_header_bytes) : 0,
          .private_offset = static_cast<std::uint32_t>(private_offset)};
}

void initialise_state(AnimationStateHeader& state, EntityType type, const EntityLayout& layout, int bone_count,
                      int components) {
  state.type = type;
  state.total_size = layout.total_size;
  state.transforms_offset = layout.transforms_offset;
  state.bone_count = static_cast<std::uint16_t>(bone_count);
  state.components = static_cast<std::uint32_t>(components);
  state.priority = highest_priority;
  state.absolute_rotation[3] = 1.0F;
}

void convert_residency(const std::byte* from, std::byte* to, const EntityLayout& from_layout,
                       const EntityLayout& to_layout) {
  assert(from_layout.private_bytes() == to_layout.private_bytes());
  std::memcpy(to, from, entity_header_bytes);
  std::memcpy(to + to_layout.private_offset, from + from_layout.private_offset, from_layout.private_bytes());
  auto& state = *reinterpret_cast<AnimationStateHeader*>(to);
  state.total_size = to_layout.total_size;
  state.transforms_offset = to_layout.transforms_offset;
}

}  // namespace throng::anim
