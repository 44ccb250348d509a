#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "app/show/scene_lines.h"

namespace throng::app {

class Followers;
class Stage;

/// The whole path of the selected person of a recorded crowd, as a line on the ground.
class PathInView {
 public:
  static constexpr std::size_t most_points = 8192;

  /// Adds the path: solid as far as it is walked, paler where it goes on. Adds nothing where no person of a recorded
  /// crowd is selected. Finds the points once a person, or in each frame while rows still come.
  void add(SceneLines& lines, const Stage& stage);

 private:
  struct Point {
    glm::vec3 place{0.0F};
    double seconds = 0.0;  // of the file's clock
  };
  void find(const Followers& followers, std::uint32_t agent);

  std::vector<Point> points_;
  std::uint64_t crowd_ = 0;  // the crowd whose points are known; 0: none are
  std::uint32_t agent_ = 0;
};

}  // namespace throng::app
