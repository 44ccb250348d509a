#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "app/crowd/layout.h"

namespace throng::app {

/// Gives some of the loose groups of a plaza something to do together: one takes a picture of the others, or all look
/// at the nearest of `sights` and one takes a picture of it. Who stands alone waits. Groups stay on their ground.
void draw_gatherings(CrowdLayout& layout, std::span<const glm::dvec2> sights, double spacing, std::uint32_t seed);

}  // namespace throng::app
