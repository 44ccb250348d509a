#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/anim/base/result.h"
#include "engine/anim/run/agent_work.h"
#include "engine/anim/run/double_buffer.h"

namespace throng::anim {

enum class Schedule : std::uint8_t {
  fused,   ///< ours: whole trees of a tile in one stay in the local store, no barrier
  levels,  ///< the paper's: players, then blenders priority by priority, a barrier in between
};

/// How a local store is divided for one schedule.
struct LocalStorePlan {
  int width = 1;  ///< characters a tile
  std::size_t fetch_bytes = 0;
  std::size_t scratch_bytes = 0;
};

struct LocalStoreDemand {
  std::string skeleton;  ///< for the error
  Schedule schedule = Schedule::fused;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  bool any_sampled = true;  ///< kinds of players that the clips need
  bool any_keyframe = false;
};

/// Bytes that a tile of `width` characters takes of a store.
std::size_t local_store_bytes(const UpdateContext& context, const LocalStoreDemand& demand, int width);

/// The widest tile that fits `size` bytes, or exactly `tile` if that is not 0. The error names skeleton, schedule,
/// stream, bytes needed and the smallest size that works, or the largest tile that fits.
Result<LocalStorePlan> plan_local_store(const UpdateContext& context, const LocalStoreDemand& demand, std::size_t size,
                                        int tile);

inline constexpr std::size_t usual_local_store_bytes = 64 * 1024;

/// The usual size, or the next power of two that holds one character's largest task.
std::size_t automatic_local_store(const UpdateContext& context, const LocalStoreDemand& demand);

}  // namespace throng::anim
