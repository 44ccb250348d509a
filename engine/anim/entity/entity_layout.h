#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/animation_state.h"

namespace throng::anim {

enum class Residency : std::uint8_t { transient, resident };

/// Where the parts of an entity's block lie (drawn in animation_state.h).
struct EntityLayout {
  std::uint32_t total_size = 0;
  std::uint32_t transforms_offset = 0;  ///< 0: transient
  std::uint32_t private_offset = 0;     ///< interpolation structures; == total_size where there are none

  /// Bytes that a source costs to fetch: header and transforms, without the private part.
  std::uint32_t source_bytes() const { return private_offset; }
  std::uint32_t private_bytes() const { return total_size - private_offset; }
  /// Bytes of a transient block that an update changes: from identity_bytes on.
  std::uint32_t changed_bytes() const { return total_size - static_cast<std::uint32_t>(identity_bytes); }
};

EntityLayout entity_layout(EntityType type, Residency residency, int bone_count, int components);

/// Fills the system information of a new, zeroed block.
void initialise_state(AnimationStateHeader& state, EntityType type, const EntityLayout& layout, int bone_count,
                      int components);

/// Copies a block to the zeroed block of the other residency: all but the transforms, which the next update makes anew.
void convert_residency(const std::byte* from, std::byte* to, const EntityLayout& from_layout,
                       const EntityLayout& to_layout);

}  // namespace throng::anim
