#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/show/scene_lines.h"

namespace throng::app {

class Followers;
class Stage;

/// Lines on the ground where people of a recorded crowd went in the last seconds. They follow from the time alone, so
/// they are right after any jump of the clock. Places are kept at even times, so a frame computes only the new ones.
class Trails {
 public:
  /// Adds the trails of all people who are there, as Tuning::trail_seconds says, fainter towards the past; nothing in
  /// other scenes. They have the colours of a view that shows a measure; the selected person's has a colour of its own.
  /// Leaves out points whose line looks the same without them in a picture of that size as `camera` sees it. Allocates
  /// when people or seconds are more than before.
  void add(SceneLines& lines, const Stage& stage, const render::Camera& camera, glm::ivec2 picture);

 private:
  /// A point of a person's way, and how long ago the person was there, in seconds.
  struct Point {
    glm::vec3 place;
    float age;
  };
  /// The times, in steps, at which the places of a person are kept.
  struct Kept {
    std::int64_t first = 0, end = 0;
  };
  struct View;

  bool make_room(const Stage& stage);
  void keep_up(const Followers& followers, std::size_t agent, double seconds);
  void gather(const Followers& followers, std::size_t agent, double seconds);
  void draw(SceneLines& lines, const View& view, std::uint32_t color) const;
  glm::vec3& place_at(std::size_t agent, std::int64_t step);

  std::uint64_t crowd_ = 0;  // the crowd whose places are kept
  std::size_t places_a_person_ = 0;
  float seconds_ = 0.0F;           // of a trail
  std::vector<glm::vec3> places_;  // [agent][step modulo places_a_person_]
  std::vector<Kept> kept_;         // [agent]
  std::vector<Point> points_;      // of the trail that is being drawn, from now to the past
};

}  // namespace throng::app
