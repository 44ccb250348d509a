#pragma once

#include <cstddef>
#include <vector>

#include "app/character/bone_lod.h"

namespace throng::app {

/// The choice that undoes `choice`, made of an order whose levels ended at `level_counts`.
BoneLodChoice taken_back(const BoneLodChoice& choice, const std::vector<int>& level_counts);

/// `choice` with the border of `level`, 1 or more, after `bones` bones; its neighbours give way, so that every level
/// has fewer bones than the one before it, and one at least.
BoneLodChoice with_border_moved(BoneLodChoice choice, std::size_t level, int bones);

}  // namespace throng::app
