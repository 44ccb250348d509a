#pragma once

#include <cstddef>

#include "app/character/bone_lod.h"

namespace throng::app {

struct TabContext;

/// Shows the bones in level-of-detail order, with the cost and the error of each. A person drags a bone to another
/// place, or the line at which a level ends, and can take the last change back.
void show_bone_list(const TabContext& context);
/// Returns `choice` with the end of `level`, 1 or more, after `bones` bones. Its neighbours give way, so that every
/// level has fewer bones than the one before it, and at least one.
BoneLodChoice with_border_moved(BoneLodChoice choice, std::size_t level, int bones);

}  // namespace throng::app
