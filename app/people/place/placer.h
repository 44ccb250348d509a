#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/people/crowd/fixtures.h"
#include "app/people/place/place.h"
#include "engine/base/random.h"

namespace throng::app {

/// The width of a bay of a house, in metres.
inline constexpr double bay_width = 6.0;
/// The depth of a house, in metres.
inline constexpr double house_depth = 9.1;

inline constexpr glm::dvec2 towards_x{1.0, 0.0}, towards_z{0.0, 1.0};

/// The tint of sRGB bytes.
constexpr std::uint32_t tint_of(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return red | (green << 8U) | (blue << 16U) | 0xFF000000U;
}

/// Puts props into a place. Props are as large as the characters need.
class Placer {
 public:
  Placer(Surroundings& place, double unit, Random random) : place_(place), unit_(unit), random_(random) {}

  /// How a prop stands where it is put.
  struct Stance {
    double height = 0.0;  ///< metres above the ground
    glm::dvec3 stretch{1.0};
    std::uint32_t tint = render::no_tint;
  };
  /// Puts a prop at x, z with its front in the direction of `heading`.
  void put(Prop prop, glm::dvec2 at, const Heading& heading, const Stance& stance);
  void put(Prop prop, glm::dvec2 at, const Heading& heading) { put(prop, at, heading, {}); }

  /// Puts houses side by side from one point to another, with their fronts towards `facing`. Bays are stretched to fill
  /// the row.
  enum class Houses : std::uint8_t { mixed, arcades };
  void put_houses(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, Houses houses);

  /// Puts such a row, with more houses behind it that look the other way. These leave the corners of the block free.
  void put_block(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, Houses houses);

  /// Puts one of the trees, turned and grown at random.
  void put_tree(glm::dvec2 at);

  /// Puts hills and roofs around the horizon, beyond a place that reaches `reach` metres from the origin.
  void put_horizon(double reach);

  double unit() const { return unit_; }
  Random& random() { return random_; }

 private:
  Surroundings& place_;
  double unit_;
  Random random_;
};

}  // namespace throng::app
