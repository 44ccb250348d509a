#pragma once

#include <optional>
#include <span>

#include "engine/anim/run/fused_tasks.h"
#include "engine/anim/run/shared_sources.h"

namespace throng::anim {

/// A tile in the local store.
struct FusedTasks::Characters {
  const UpdateContext* context;
  std::span<const AgentWork> work;
  std::byte* blocks;
  std::optional<SharedSources> shared;  ///< where they read any
  const std::byte* shared_blocks;
  int width;
  int packets;
  int held_packets;  ///< the first ones, kept until they are whole; 0: streaming

  const AnimationStateHeader& shared_state(Handle entity) const {
    return *reinterpret_cast<const AnimationStateHeader*>(shared->block(*context->pools, entity, shared_blocks));
  }
};

}  // namespace throng::anim
