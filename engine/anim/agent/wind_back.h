#pragma once

#include "engine/anim/agent/population.h"

namespace throng::anim {

/// Returns whether the pose of an agent at the clock can be found, although the agent may stand ahead of it. See
/// AgentView::can_pose_exactly.
bool can_pose_exactly(const Population& population, std::uint32_t agent);

/// Returns whether an update may take the agent back to the clock. See AgentView::can_wind_back.
bool can_wind_back(const Population& population, std::uint32_t agent);

}  // namespace throng::anim
