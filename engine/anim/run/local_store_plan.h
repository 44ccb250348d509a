#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "engine/anim/bake/character.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/store/double_buffer.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/schedule.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The demand on a store. It must hold tiles of usual graphs, which are up to four players and the blenders over them,
/// and at least one character of the largest graph.
struct LocalStoreDemand {
  std::string skeleton;  ///< for the error
  Schedule schedule = Schedule::fused;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  StreamKind stream = StreamKind::sampled;  ///< wanted; clips that have no such stream play the other
  bool plays_keys = false;                  ///< some clip of that skeleton plays from its keys; for the error
  StoreNeeds largest;                       ///< the largest needs of all programs of agents
  std::size_t shared_entity_bytes = 0;      ///< the most StoreNeeds::entity_bytes of all graphs of shared entities
};

/// Returns the bytes of a store that a tile of one strip of `width` characters takes.
std::size_t local_store_bytes(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand, int width);

/// Divides `size` bytes for the widest strips that fit, and for tiles of several strips if these fit, too. A `tile`
/// other than 0 asks for tiles of one strip of exactly so many characters. The error names skeleton, schedule, stream,
/// the bytes that are needed, and the smallest size that works or the largest tile that fits.
Result<LocalStorePlan> plan_local_store(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand,
                                        std::size_t size, int tile);

/// Returns whether a character of these needs fits the store as it is divided.
bool plan_holds(const LocalStorePlan& plan, const UpdateContext& context, Schedule schedule, const StoreNeeds& needs);

inline constexpr std::size_t usual_local_store_bytes = 64 * 1024;

/// Returns the usual size, or the next power of two that holds the largest task of one character.
std::size_t automatic_local_store(std::span<const UpdateContext> contexts, const LocalStoreDemand& demand);

}  // namespace throng::anim
