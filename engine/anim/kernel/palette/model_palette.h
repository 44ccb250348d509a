#pragma once

#include <cstdint>

#include "engine/anim/base/pose.h"
#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/anim/kernel/palette/write_lines.h"

namespace throng::anim {

/// Computes model space and palette of one packet of `width` characters of one skeleton. Packets are done in order, 0
/// first. `carry` holds the last bone's transform between them.
struct JointProgram;
inline constexpr int branch_slot_floats = 12;  ///< a lane's floats in `carry` and in each branch slot, at most
struct ModelPaletteJob {
  const HierarchyProgram* hierarchy = nullptr;
  int packet = 0;
  int bone_count = 0;              ///< bones of the level; bones at and above it are not touched
  int width = widest_strip;        ///< 1, 2, 4, 8 or 16
  int characters = widest_strip;   ///< 1 to width; further lanes are computed from garbage-free input, not written
  const float* local = nullptr;    ///< [width][components][16]
  QuadMask displaced = all_quads;  ///< on rigid skeletons: positions of others are 0, and are not read
  StorePolicy stores = StorePolicy::prefetched;
  float* carry = nullptr;                          ///< in and out, [branch_slot_floats][width]
  float* branch_slots = nullptr;                   ///< in and out, [slot_count][branch_slot_floats][width]
  PaletteFormat format = PaletteFormat::matrices;  ///< packed: where the hierarchy `packs`
  const PaletteDestination* palettes =
      nullptr;                           ///< [characters], 16-byte aligned; the kernel writes entries in ascending
                                         ///< order, whole cache lines where it can, and never reads them
  std::uint64_t* hashes = nullptr;       ///< [characters] or null: adds each written entry's hash, see palette_hash.h
  const JointProgram* joints = nullptr;  ///< of the same level, or null: joints that are written on the way; the format
                                         ///< is matrices
  float* const* joints_to = nullptr;     ///< [width], as ModelJointsJob::to
};
bool is_valid(const ModelPaletteJob& job);

}  // namespace throng::anim
