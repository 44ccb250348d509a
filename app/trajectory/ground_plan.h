#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace throng::app {

/// A polygon on the ground: x and z in metres. The last corner joins the first, which is not repeated.
using GroundRing = std::vector<glm::vec2>;

/// An area with holes, which are obstacles where the area can be walked on.
struct GroundArea {
  GroundRing outline;
  std::vector<GroundRing> holes;
};

/// An open line on the ground, at least two points.
struct GroundLine {
  std::vector<glm::vec2> points;
  std::string name;  ///< may be empty
};

/// The place of a recorded or simulated crowd, as far as its files say it.
struct GroundPlan {
  std::vector<GroundArea> floors;     ///< where people can walk: their outlines and holes are walls
  std::vector<GroundRing> obstacles;  ///< solid
  std::vector<GroundLine> walls;      ///< upright, without thickness
  std::vector<GroundArea> exits;
  std::vector<GroundLine> measurement_lines;

  bool is_empty() const {
    return floors.empty() && obstacles.empty() && walls.empty() && exits.empty() && measurement_lines.empty();
  }
};

}  // namespace throng::app
