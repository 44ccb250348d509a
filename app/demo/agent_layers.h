#pragma once

#include <cstdint>
#include <vector>

#include "app/report/selection_report.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// The channels of an agent, from the first to the one laid over all, then what changes their pose, in the order in
/// which it does; as its blocks stand after the last update. An entity that several channels read is the first's.
std::vector<LayerRow> agent_layers(const anim::AnimationSystem& system, std::uint32_t agent);

}  // namespace throng::app
