#pragma once

#include <cstdint>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// Poses 120 agents over 20 frames and returns their pose hash. Of these agents some look at things, some tremble, some
/// do both, in either order, some turn by where their bones are, and some do nothing. Half of them play one clip, half
/// two. The last bone level lacks the head.
std::uint64_t hash_of_held_crowd(const SystemOptions& options);

}  // namespace throng::anim
