#pragma once

#include <vector>

#include "app/show/report/selection_report.h"
#include "engine/anim/entity/animation_state.h"

namespace throng::app {

/// Returns the fields of an entity's header (paper 2.2.1), and a player's own fields (2.2.2).
std::vector<BlockField> block_fields(const anim::AnimationStateHeader& state);

}  // namespace throng::app
