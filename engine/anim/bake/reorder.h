#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Counts the palette entries of each level.
std::vector<std::uint32_t> entries_of_levels(const Skeleton& skeleton);

}  // namespace throng::anim
