#pragma once

#include <glm/vec3.hpp>

namespace throng::render {

/// The air of the earth as a camera on the ground sees it by day and in twilight: light is scattered by molecules, haze
/// and ozone, many times (Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", 2020).
/// Light is linear; the sun outside of the air shines with 1.
class Atmosphere {
 public:
  explicit Atmosphere(const glm::vec3& to_sun) : to_sun_(to_sun) {}

  /// Returns what a direction, unit and not below the horizon, looks like, without the sun's own disc.
  glm::vec3 radiance(const glm::vec3& direction) const;

  /// Returns how much of the sun's light arrives at the ground; 0 once it has set.
  glm::vec3 sunlight() const;

 private:
  glm::vec3 to_sun_;
};

}  // namespace throng::render
