#pragma once

#include <optional>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "engine/tracks/trajectories.h"

namespace throng {

/// A rectangle on the ground: x and z in metres.
struct GroundBounds {
  glm::vec2 low{0.0F}, high{0.0F};

  friend bool operator==(const GroundBounds&, const GroundBounds&) = default;
};

/// Widens bounds to hold a place.
inline void add_to(GroundBounds& bounds, const glm::vec2& place) {
  bounds.low = glm::min(bounds.low, place);
  bounds.high = glm::max(bounds.high, place);
}
inline void add_to(GroundBounds& bounds, const TrackRow& row) { add_to(bounds, glm::vec2(row.x, row.z)); }

inline float width_of(const GroundBounds& bounds) {
  return glm::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
}

/// Returns the bounds of a plan; nothing where it is empty.
std::optional<GroundBounds> bounds_of(const GroundPlan& plan);

/// Returns the bounds of all people at every time. While rows still come, they hold the plan too, or else a few metres
/// around the first row.
GroundBounds bounds_of(const Trajectories& trajectories);

}  // namespace throng
