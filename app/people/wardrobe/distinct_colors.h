#pragma once

#include <cstdint>
#include <vector>

#include "app/people/wardrobe/cast_rules.h"

namespace throng::app {

/// Returns, for each colour of a palette, the first colour that looks like it on two people, since cloth fades.
/// Two colours count as one if a third looks like both.
std::vector<std::uint32_t> distinct_colors(const Palette& palette);

}  // namespace throng::app
