#pragma once

#include <cstdint>

namespace throng::anim {

enum class Schedule : std::uint8_t {
  fused,   ///< ours: whole trees of a tile in one stay in the local store, no barrier
  levels,  ///< the paper's: players, then blenders priority by priority, a barrier in between
};

/// Paper footnote 7: "while the CPU processes one animation player the DMA controller moves the next/previous one
/// in/out".
///   off          one fetch buffer: fetch, compute, write back
///   inline_copy  two: the previous task goes out and the next comes in before this one is computed
///   interleaved  two: the same bytes move from inside the kernels' loop over packets of bones. They are asked for in
///                slices, as a controller would have them under way, and are here with the last slice
enum class DoubleBuffering : std::uint8_t { off, inline_copy, interleaved };

/// The fate of the blocks that an update has changed in the local store.
enum class BlockChanges : std::uint8_t {
  written_back,
  dropped,  ///< the update was only a look, and entities stay where they stand
};

enum class Tracing : std::uint8_t {
  off,
  on,          ///< tasks too short to be timed one by one share a compute span, copies included: costs under 1%
  every_task,  ///< a span for each part of each task, whatever that costs
};

}  // namespace throng::anim
