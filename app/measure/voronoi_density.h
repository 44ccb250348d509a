#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/crowd/steering/cells.h"
#include "app/measure/walkable_area.h"
#include "engine/anim/base/executor.h"

namespace throng::app {

/// The people whose densities are measured.
struct MeasuredPeople {
  std::span<const glm::vec3> positions;       ///< metres
  std::span<const std::uint8_t> absent = {};  ///< [person] 1: it is not there; empty: everybody is
};

/// Measures the density at everybody as PedPy does (compute_individual_voronoi_polygons of pedpy.methods.method_utils):
/// somebody's ground is all that nobody else is nearer to, at most as far as a cut-off, within the area that people can
/// walk on; if walls cut it into parts, the one with the person in it. The density is one over its square metres. Two
/// people at the same place share their ground.
class VoronoiDensity {
 public:
  /// Writes people a square metre for each person; below 0 for who is not there, or has no ground to stand on.
  /// Allocates nothing once as many people were there. `jobs` run at once on `executor`; the result does not depend on
  /// either.
  void measure(const MeasuredPeople& people, float cut_off, const WalkableArea& area, anim::Executor& executor,
               int jobs, std::span<float> densities);

 private:
  CrowdCells neighbours_;
  std::vector<Body> bodies_;
};

/// Corners of the polygon that stands for a circle of the cut-off: those of PedPy's Cutoff, three to a quarter.
inline constexpr int cut_off_corners = 12;

}  // namespace throng::app
