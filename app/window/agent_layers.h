#pragma once

#include <cstdint>
#include <vector>

#include "app/show/report/selection_report.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// Returns the channels of an agent from the bottom layer to the top one, then its post-processes in order, as their
/// blocks are after the last update. An entity that several channels read is listed with the first of them.
std::vector<LayerRow> agent_layers(const anim::AnimationSystem& system, std::uint32_t agent);

}  // namespace throng::app
