#pragma once

#include <cstdint>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// Poses 200 agents over 20 frames and returns their pose hash. Agents start fades at different times, stand at
/// different bone levels, and a third of them skip every other update. Another seed gives another crowd.
std::uint64_t hash_of_fading_crowd(const SystemOptions& options, unsigned seed = 1);

}  // namespace throng::anim
