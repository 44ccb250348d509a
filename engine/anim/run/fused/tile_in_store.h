#pragma once

#include <span>

#include "engine/anim/run/fused/scratch.h"
#include "engine/anim/run/program/shared_sources.h"
#include "engine/anim/run/program/tile.h"

namespace throng::anim {

/// A tile whose blocks lie in a fetch buffer:
///
///     [blocks of character 0 in the order of its steps | of character 1 | ... | shared sources]
struct TileInStore {
  const UpdateContext* context;
  std::span<const AgentWork> work;
  std::span<const AgentRun> runs;
  std::byte* blocks;                      ///< the blocks of its first character
  const SharedSources* shared = nullptr;  ///< null: its characters read none
  const std::byte* shared_blocks = nullptr;

  /// Returns the bytes of the blocks that its characters own.
  std::size_t own_bytes() const {
    std::size_t bytes = 0;
    for (const AgentRun& run : runs) bytes += std::size_t{run.program->needs.fetch_bytes} * run.count;
    return bytes;
  }
  const AnimationStateHeader& shared_state(Handle entity) const {
    return *reinterpret_cast<const AnimationStateHeader*>(shared->block(*context->pools, entity, shared_blocks));
  }
};

/// Characters of a tile that kernels pose side by side.
struct Strip {
  const TileInStore* tile;
  const FusedScratch* scratch;
  std::size_t first;                ///< number of its first character in the tile
  std::span<const AgentWork> work;  ///< [character of the strip]
  int width;                        ///< lanes, a power of two and no fewer than the characters
  int packets;
  int held_packets;  ///< the number of first packets that are kept until they are whole; 0: streaming

  const UpdateContext& context() const { return *tile->context; }
  /// Returns the floats from one packet of all characters to the next, where packets are held.
  std::size_t held_stride() const { return context().packet_floats() * static_cast<std::size_t>(width); }
  /// Returns the first held packet of a character. Its streamed packets lie there, too.
  float* pose(std::size_t character) const { return &scratch->model.local[character * context().packet_floats()]; }
};

}  // namespace throng::anim
