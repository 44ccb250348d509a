#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "app/settings/settings.h"

namespace throng::app {

/// The values of a tuning that decide what a picture costs, and not what it shows.
struct PictureCost {
  int picture_size = 100;   ///< Tuning::picture_size
  int triangle_budget = 0;  ///< Tuning::triangle_budget; 0: no such limit
  bool shadows = true;
  bool crowd_shade = true;

  friend bool operator==(const PictureCost&, const PictureCost&) = default;
};

/// The keys of these values in tuning_values().
inline constexpr std::array picture_cost_keys{"picture_size", "triangle_budget", "shadows", "crowd_shade"};

inline PictureCost cost_of(const Tuning& tuning) {
  return {tuning.picture_size, tuning.triangle_budget, tuning.shadows, tuning.crowd_shade};
}

inline void set_cost(Tuning& tuning, const PictureCost& cost) {
  tuning.picture_size = cost.picture_size;
  tuning.triangle_budget = cost.triangle_budget;
  tuning.shadows = cost.shadows;
  tuning.crowd_shade = cost.crowd_shade;
}

/// The costs in the order in which a window that holds a frame rate goes down them: light first, then pixels and
/// triangles together, since a smaller picture shows less of a mesh.
inline constexpr std::array picture_costs = std::to_array<PictureCost>({
    {100, 0, true, true},
    {100, 0, true, false},
    {100, 0, false, false},
    {85, 400'000, false, false},
    {72, 320'000, false, false},
    {62, 250'000, false, false},
    {54, 190'000, false, false},
    {48, 150'000, false, false},
    {44, 120'000, false, false},
    {40, 95'000, false, false},
    {36, 75'000, false, false},
    {32, 62'000, false, false},
    {28, 52'000, false, false},
    {25, 42'000, false, false},
    {25, 25'000, false, false},
});

/// A name for one of these costs.
struct Quality {
  const char* name;
  std::size_t cost;  ///< index into picture_costs
};

inline constexpr std::array qualities = std::to_array<Quality>({{"low", 10}, {"medium", 5}, {"high", 0}});
/// The name beside them, of a window that holds a frame rate.
inline constexpr const char* automatic_quality = "auto";

/// Takes a quality by its name. Returns false for another name, and changes nothing.
inline bool take_quality(std::string_view name, Tuning& tuning) {
  const auto* const named = std::ranges::find(qualities, name, &Quality::name);
  if (named == qualities.end() && name != automatic_quality) return false;
  tuning.holds_rate = named == qualities.end();
  if (!tuning.holds_rate) set_cost(tuning, picture_costs[named->cost]);
  return true;
}

/// Returns the name of the quality that a tuning has; empty where its values have no name.
inline std::string_view quality_of(const Tuning& tuning) {
  if (tuning.holds_rate) return automatic_quality;
  const auto* const named =
      std::ranges::find_if(qualities, [&](const Quality& each) { return picture_costs[each.cost] == cost_of(tuning); });
  return named == qualities.end() ? std::string_view() : named->name;
}

}  // namespace throng::app
