#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/run/agent_work.h"
#include "engine/anim/run/tile_scratch.h"

namespace throng::anim {

struct LocalStorePlan;

/// The scratch of a tile of `width` characters in the `fused` schedule.
///
///     model      see tile_scratch.h; local poses of a held tile are the first held ones, which are done by then
///     registers  float [registers][components][16]                 streaming: one packet of one character
///                float [registers][held packets][components][16]   held: poses of one character
///     prepared   std::byte [width][prepared bytes]
///     held       float [held packets][width][components][16]       held tiles only
struct FusedScratch {
  ModelScratch model;
  std::span<float> registers;
  std::size_t register_floats = 0;  ///< from one register to the next
  std::span<std::byte> prepared;
  std::span<float> held;

  static FusedScratch carve(ScratchCarver& carver, const UpdateContext& context, const StoreNeeds& needs, int width);
  static std::size_t bytes(const UpdateContext& context, const StoreNeeds& needs, int width);
};

/// The widest tile, 16 or less, of characters of these needs, that read `shared_bytes` together, whose blocks and
/// scratch fit; 0: not even one.
int widest_fused_tile(const UpdateContext& context, const StoreNeeds& needs, std::size_t shared_bytes,
                      const LocalStorePlan& plan);

}  // namespace throng::anim
