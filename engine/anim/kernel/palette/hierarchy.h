#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/kernel/palette/packed_palette.h"

namespace throng::anim {

/// The work of the model-palette kernel for one bone. Depth-first chains stay in registers: a bone whose parent is the
/// previous bone takes its transform from there. Only branch points are saved to a slot.
struct HierarchyStep {
  static constexpr std::int16_t from_previous = -1;  ///< the parent is the bone before
  static constexpr std::int16_t from_root = -2;      ///< no parent: identity
  static constexpr std::int16_t no_slot = -1;
  std::int16_t load = from_root;  ///< branch slot of the parent, or one of the above
  std::int16_t store = no_slot;   ///< branch slot to save this bone to
  std::int32_t first_entry = 0;   ///< general path: palette entries of this bone are
  std::int32_t entry_count = 0;   ///< [first_entry, first_entry + entry_count)
};

/// A skeleton, compiled for the kernels. Arrays are padded to whole packets; padding bones do nothing.
struct HierarchyProgram {
  bool rigid = true;
  int bone_count = 0;
  int slot_count = 0;                    ///< branch slots live at once over the whole skeleton
  std::vector<HierarchyStep> steps;      ///< one a bone
  std::vector<float> to_model_origin;    ///< rigid: x, y, z from the bone's origin to the model's, a bone
  std::vector<float> offsets;            ///< rigid: x, y, z from the parent's origin to the bone's, a bone
  float joint_step = 0;                  ///< step of packed palettes, see PackingFrame; 0 if they cannot be packed
  std::vector<float> prefixes;           ///< general: 3x4 row-major a bone, only where has_prefix
  std::vector<std::uint8_t> has_prefix;  ///< general: one a bone
  std::vector<float> posts;              ///< general: 3x4 row-major a palette entry
  std::vector<std::int16_t> skin_joint;  ///< palette entry -> index under which it is hashed: its joint in the first
                                         ///< skin that reads it, so that the hash does not depend on the bone order

  bool packs() const { return joint_step > 0.0F; }
};

/// Returns the frames that unpack the palette's entries, one each; none if palettes of this skeleton cannot be packed.
/// They can if it is rigid and its joints have some extent at rest. The extent gives the box that positions are packed
/// in: 16 to 32 times as far as the farthest coordinate, 32 m to each side for a person. A joint that moves farther is
/// packed at the box's side.
std::vector<PackingFrame> packing_frames(const Skeleton& skeleton);

/// Compiles a skeleton. Branch slots are given back after their last reader, so that a slot is live only where the
/// depth-first walk needs it.
HierarchyProgram compile_hierarchy(const Skeleton& skeleton);

}  // namespace throng::anim
