#pragma once

#include <span>

#include "engine/anim/run/fused/tasks.h"
#include "engine/anim/run/program/shared_sources.h"

namespace throng::anim {

/// A tile in the local store, or a strip of it.
struct FusedTasks::Characters {
  const UpdateContext* context;
  std::span<const AgentWork> work;
  const PoseProgram* program;   ///< of all of them; null: several
  const SharedSources* shared;  ///< null: they read none
  const std::byte* shared_blocks;
  int width;  ///< of a strip
  int packets;
  int held_packets;  ///< the first ones, kept until they are whole; 0: streaming

  const AnimationStateHeader& shared_state(Handle entity) const {
    return *reinterpret_cast<const AnimationStateHeader*>(shared->block(*context->pools, entity, shared_blocks));
  }
};

/// Of the blocks that the characters of a tile own.
inline std::size_t own_bytes(std::span<const AgentWork> tile) {
  std::size_t bytes = 0;
  for (const AgentWork& work : tile) bytes += work.program->needs.fetch_bytes;
  return bytes;
}

}  // namespace throng::anim
