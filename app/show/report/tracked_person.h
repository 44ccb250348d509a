#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/tracks/presence.h"

namespace throng::app {

/// A foot comes down.
struct Footfall {
  double seconds = 0.0;  ///< of the file's clock
  bool is_left = false;
};

/// A person of a recorded crowd over the whole time in which the person is there.
struct TrackedPerson {
  std::string id;  ///< as the file has it
  Presence presence;
  std::size_t rows = 0;
  float stature = 0.0F;             ///< metres
  glm::dvec2 origin{0.0};           ///< of the file's coordinates (Trajectories::origin)
  std::vector<float> speeds;        ///< metres a second, evenly over the presence, at least two
  std::vector<float> ways;          ///< metres walked until each of these times
  std::vector<Footfall> footfalls;  ///< in ascending time, as far as they are found
  bool has_all_footfalls = false;

  /// Returns a value at a time of the presence.
  [[nodiscard]] float speed_at(double seconds) const { return at(speeds, seconds); }
  [[nodiscard]] float way_at(double seconds) const { return at(ways, seconds); }
  [[nodiscard]] float fastest() const { return *std::ranges::max_element(speeds); }
  /// Returns how many feet came down until a time.
  [[nodiscard]] std::size_t steps_until(double seconds) const {
    const auto later = std::ranges::upper_bound(footfalls, seconds, {}, &Footfall::seconds);
    return static_cast<std::size_t>(later - footfalls.begin());
  }

 private:
  [[nodiscard]] float at(const std::vector<float>& values, double seconds) const {
    const double length = presence.last - presence.first;
    const double share = length > 0.0 ? std::clamp((seconds - presence.first) / length, 0.0, 1.0) : 0.0;
    const double place = share * static_cast<double>(values.size() - 1);
    const auto before = std::min(static_cast<std::size_t>(place), values.size() - 2);
    return std::lerp(values[before], values[before + 1], static_cast<float>(place - static_cast<double>(before)));
  }
};

}  // namespace throng::app
