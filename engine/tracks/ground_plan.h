#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace throng {

/// The place of a recorded or simulated crowd, as far as its files say it. Points are of the type `Point`.
template <typename Point>
struct Plan {
  /// A polygon on the ground. The last corner joins the first, which is not repeated.
  using Ring = std::vector<Point>;

  /// A polygon with holes, which are obstacles where the polygon can be walked on.
  struct Area {
    Ring outline;
    std::vector<Ring> holes;
  };
  /// An open line, at least two points.
  struct Line {
    Ring points;
    std::string name = {};  ///< may be empty
  };

  std::vector<Area> floors;     ///< where people can walk: their outlines and holes are walls
  std::vector<Ring> obstacles;  ///< solid
  std::vector<Line> walls;      ///< upright, without thickness
  std::vector<Area> exits;
  std::vector<Line> measurement_lines;
  std::size_t unknown_shapes = 0;  ///< of the file, which are left out

  bool is_empty() const {
    return floors.empty() && obstacles.empty() && walls.empty() && exits.empty() && measurement_lines.empty();
  }
};

/// Calls visit(point) for each point of floors, obstacles and walls.
template <typename Point, typename Visit>
void for_points(const Plan<Point>& plan, Visit visit) {
  for (const auto* const areas : {&plan.floors, &plan.exits}) {
    for (const auto& area : *areas) std::ranges::for_each(area.outline, visit);
  }
  for (const auto& ring : plan.obstacles) std::ranges::for_each(ring, visit);
  for (const auto& line : plan.walls) std::ranges::for_each(line.points, visit);
}

/// A plan in the program's axes: x and z in metres.
using GroundPlan = Plan<glm::vec2>;
using GroundRing = GroundPlan::Ring;
using GroundArea = GroundPlan::Area;
using GroundLine = GroundPlan::Line;

}  // namespace throng
