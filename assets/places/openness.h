#pragma once

#include <array>
#include <vector>

#include "assets/places/mesh_builder.h"

namespace throng::places {

/// How open the surroundings of each face's corners are: 1 in the open, less in recesses, below sills and at the foot
/// of walls. What is further away than `reach` metres does not darken.
std::vector<std::array<double, 4>> corner_openness(const std::vector<Face>& faces, double reach);

}  // namespace throng::places
