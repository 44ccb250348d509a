#include "engine/render/light/atmosphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/render/even_directions.h"

namespace throng::render {
namespace {

using std::numbers::pi_v;

// Kilometres, and shares a kilometre, from table 1 of Hillaire 2020.
constexpr float ground = 6360.0F, top = 6460.0F;
constexpr float eye = ground + 0.1F;
constexpr glm::vec3 rayleigh_scattering{5.802e-3F, 13.558e-3F, 33.1e-3F};
constexpr float haze_scattering = 3.996e-3F, haze_absorption = 4.4e-3F;
constexpr glm::vec3 ozone_absorption{0.65e-3F, 1.881e-3F, 0.085e-3F};
constexpr float rayleigh_height = 8.0F, haze_height = 1.2F, ozone_height = 25.0F, half_ozone_layer = 15.0F;
constexpr float haze_forwardness = 0.76F;
constexpr float albedo_below = 0.3F;

struct Air {
  glm::vec3 rayleigh;
  float haze;
  glm::vec3 extinction;
};

Air air_at(float radius) {
  const float height = std::max(radius - ground, 0.0F);
  const glm::vec3 rayleigh = rayleigh_scattering * std::exp(-height / rayleigh_height);
  const float haze = std::exp(-height / haze_height);
  const float ozone = std::max(1.0F - std::abs(height - ozone_height) / half_ozone_layer, 0.0F);
  return {rayleigh, haze_scattering * haze,
          rayleigh + glm::vec3((haze_scattering + haze_absorption) * haze) + ozone_absorption * ozone};
}

// `rise` is the cosine between the ray and straight up. Differences of squares are products, because floats of
// squared kilometres are whole kilometres off.
float ground_squared_below(float radius, float rise) {
  return radius * radius * rise * rise - (radius - ground) * (radius + ground);
}
bool meets_ground(float radius, float rise) { return rise < 0.0F && ground_squared_below(radius, rise) >= 0.0F; }
float way_to_top(float radius, float rise) {
  return -radius * rise + std::sqrt(radius * radius * rise * rise + std::max((top - radius) * (top + radius), 0.0F));
}
float way_to_ground(float radius, float rise) {
  return -radius * rise - std::sqrt(std::max(ground_squared_below(radius, rise), 0.0F));
}
float radius_after(float radius, float rise, float way) {
  return std::sqrt(std::max(radius * radius + way * way + 2.0F * radius * rise * way, ground * ground));
}

/// A function of height and of the sine of an elevation, in a table that is finest near the ground and the horizon.
template <std::size_t heights, std::size_t rises>
class Table {
 public:
  explicit Table(const auto& value_at) {
    for (std::size_t h = 0; h < heights; ++h) {
      for (std::size_t r = 0; r < rises; ++r) values_[h][r] = value_at(radius_of(h), rise_of(r));
    }
  }

  glm::vec3 at(float radius, float rise) const {
    const float h = std::sqrt(std::clamp((radius - ground) / (top - ground), 0.0F, 1.0F)) * (heights - 1);
    const float side = std::sqrt(std::min(std::abs(rise), 1.0F));
    const float r = (0.5F + 0.5F * (rise < 0.0F ? -side : side)) * (rises - 1);
    const std::size_t row = std::min(static_cast<std::size_t>(h), heights - 2);
    const std::size_t column = std::min(static_cast<std::size_t>(r), rises - 2);
    const auto between = [&](std::size_t in_row) {
      return glm::mix(values_[in_row][column], values_[in_row][column + 1], r - static_cast<float>(column));
    };
    return glm::mix(between(row), between(row + 1), h - static_cast<float>(row));
  }

 private:
  static float radius_of(std::size_t row) {
    const float share = static_cast<float>(row) / (heights - 1);
    return ground + (top - ground) * share * share;
  }
  static float rise_of(std::size_t column) {
    const float side = 2.0F * static_cast<float>(column) / (rises - 1) - 1.0F;
    return side < 0.0F ? -side * side : side * side;
  }

  std::array<std::array<glm::vec3, rises>, heights> values_{};
};

glm::vec3 compute_clearness(float radius, float rise) {
  if (meets_ground(radius, rise)) return glm::vec3(0.0F);
  constexpr int steps = 40;
  const float step = way_to_top(radius, rise) / steps;
  glm::vec3 depth(0.0F);
  for (int i = 0; i < steps; ++i) {
    depth += air_at(radius_after(radius, rise, (static_cast<float>(i) + 0.5F) * step)).extinction * step;
  }
  return glm::exp(-depth);
}

/// Returns the share of light that comes through the air from a direction; 0 from behind the ground.
glm::vec3 clearness(float radius, float rise) {
  static const Table<32, 256> table(compute_clearness);
  return table.at(radius, rise);
}

/// Walks along a ray from `radius`, and calls `scatter(air, radius, way)` at each step for the light that is scattered
/// into it. Returns the arriving light.
glm::vec3 gather(float radius, float rise, float length, int steps, const auto& scatter) {
  glm::vec3 arriving(0.0F), clear(1.0F);
  float before = 0.0F;
  for (int i = 0; i < steps; ++i) {
    // Steps grow, because the air is thickest near the ground.
    const float share = static_cast<float>(i + 1) / static_cast<float>(steps);
    const float after = length * share * share;
    const float step = after - before, way = before + 0.5F * step;
    before = after;
    const float there = radius_after(radius, rise, way);
    const Air air = air_at(there);
    const glm::vec3 through = glm::exp(-air.extinction * step);
    arriving += clear * scatter(air, there, way) * (1.0F - through) / glm::max(air.extinction, glm::vec3(1e-7F));
    clear *= through;
  }
  return arriving;
}

/// Returns the light that a place receives, from all around alike, after it was scattered at least once before.
glm::vec3 compute_scattered_again(float radius, float sun_rise) {
  constexpr int directions = 48, steps = 14;
  const glm::vec3 to_sun(std::sqrt(std::max(1.0F - sun_rise * sun_rise, 0.0F)), sun_rise, 0.0F);
  glm::vec3 once(0.0F), share(0.0F);
  for (int i = 0; i < directions; ++i) {
    const glm::vec3 direction = even_direction(i, directions);
    const float rise = direction.y;
    const bool down = meets_ground(radius, rise);
    const float length = down ? way_to_ground(radius, rise) : way_to_top(radius, rise);
    const auto sun_rise_at = [&](float there, float way) {
      return (radius * sun_rise + way * glm::dot(direction, to_sun)) / there;
    };
    once += gather(radius, rise, length, steps, [&](const Air& air, float there, float way) {
      return (air.rayleigh + air.haze) * clearness(there, sun_rise_at(there, way)) / (4.0F * pi_v<float>);
    });
    share +=
        gather(radius, rise, length, steps, [](const Air& air, float, float) { return (air.rayleigh + air.haze); });
    if (!down) continue;
    const float sun = std::max(sun_rise_at(ground, length), 0.0F);
    once +=
        clearness(ground, sun) * (sun * albedo_below / pi_v<float>)*(
                                     clearness(ground, -rise) / glm::max(clearness(radius, -rise), glm::vec3(1e-4F)));
  }
  once /= directions;
  share /= directions;
  return once / (1.0F - share);
}

glm::vec3 scattered_again(float radius, float sun_rise) {
  static const Table<10, 32> table(compute_scattered_again);
  return table.at(radius, sun_rise);
}

float rayleigh_phase(float cosine) { return 3.0F / (16.0F * pi_v<float>)*(1.0F + cosine * cosine); }

// Cornette and Shanks 1992.
float haze_phase(float cosine) {
  constexpr float g = haze_forwardness;
  return 3.0F / (8.0F * pi_v<float>)*(1.0F - g * g) * (1.0F + cosine * cosine) /
         ((2.0F + g * g) * std::pow(1.0F + g * g - 2.0F * g * cosine, 1.5F));
}

}  // namespace

glm::vec3 Atmosphere::radiance(const glm::vec3& direction) const {
  constexpr int steps = 28;
  const float cosine = glm::dot(direction, to_sun_), rise = std::max(direction.y, 0.0F);
  const float rayleigh = rayleigh_phase(cosine), haze = haze_phase(cosine);
  return gather(eye, rise, way_to_top(eye, rise), steps, [&](const Air& air, float there, float way) {
    const float sun_rise = (eye * to_sun_.y + way * cosine) / there;
    return clearness(there, sun_rise) * (air.rayleigh * rayleigh + air.haze * haze) +
           scattered_again(there, sun_rise) * (air.rayleigh + air.haze);
  });
}

glm::vec3 Atmosphere::sunlight() const {
  // The disc is half a degree wide: it sets little by little.
  const float above = std::clamp((glm::degrees(std::asin(to_sun_.y)) + 0.6F) / 0.9F, 0.0F, 1.0F);
  return clearness(eye, std::max(to_sun_.y, 0.0F)) * above;
}

}  // namespace throng::render
