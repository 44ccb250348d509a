#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/store/tile_scratch.h"

namespace throng::anim {

struct LocalStorePlan;

/// The scratch of a tile in the `fused` schedule. Its strips, of up to `width` characters, use it one after the other.
///
///     prepared   std::byte [characters of the tile][prepared bytes]
///     model      see tile_scratch.h; streamed packets of a held tile lie over its first held one,
///                which is done by then
///     registers  float [registers][components][16]                 streaming: one packet of one character
///                float [registers][held packets][components][16]   held: poses of one character
///     held       float [held packets][width][components][16]       held tiles only
struct FusedScratch {
  std::span<std::byte> prepared;
  ModelScratch model;
  std::span<float> registers;
  std::size_t register_floats = 0;  ///< from one register to the next
  std::span<float> held;

  static FusedScratch carve(ScratchCarver& carver, const UpdateContext& context, const StoreNeeds& needs, int width,
                            std::size_t characters);
  static std::size_t bytes(const UpdateContext& context, const StoreNeeds& needs, int width, std::size_t characters);
};

struct FusedFit {
  int width = 0;       ///< characters of a strip
  int characters = 0;  ///< characters of a tile of one strip or several
};

/// Returns the widest strip and the largest tile whose blocks and scratch fit the plan, for characters of these needs
/// that read `shared_bytes` together. Returns zeros if not even one character fits.
FusedFit fused_fit(const UpdateContext& context, const StoreNeeds& needs, std::size_t shared_bytes,
                   const LocalStorePlan& plan);

}  // namespace throng::anim
