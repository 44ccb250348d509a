#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "throng/host.h"

#include "app/people/crowd/steering/cells.h"
#include "app/people/measure/walkable_area.h"

namespace throng::app {

/// The people whose densities are measured.
struct MeasuredPeople {
  std::span<const glm::vec3> positions;       ///< metres
  std::span<const std::uint8_t> absent = {};  ///< [person] 1: it is not there; empty: all are
};

/// Measures the density at each person as PedPy does (compute_individual_voronoi_polygons of
/// pedpy.methods.method_utils): a person's ground is all ground that no other is nearer to, up to a cut-off, within the
/// area that people can walk on; if walls cut it into parts, the part with the person in it. The density is one over
/// its square metres. Two people at the same place share their ground.
class VoronoiDensity {
 public:
  /// Writes people a square metre for each person; below 0 for a person who is absent or has no ground to stand on.
  /// Allocates only for more people than ever before. `jobs` run at once on `executor`; the result does not depend on
  /// either.
  void measure(const MeasuredPeople& people, float cut_off, const WalkableArea& area, Executor& executor, int jobs,
               std::span<float> densities);

 private:
  CrowdCells neighbours_;
  std::vector<Body> bodies_;
};

/// Corners of the polygon that stands for a circle of the cut-off: as in PedPy's Cutoff, three to a quarter.
inline constexpr int cut_off_corners = 12;

}  // namespace throng::app
