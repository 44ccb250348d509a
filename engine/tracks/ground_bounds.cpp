#include "engine/tracks/ground_bounds.h"

#include <limits>

namespace throng {
namespace {

constexpr float around_first = 4.0F;  // metres

}  // namespace

std::optional<GroundBounds> bounds_of(const GroundPlan& plan) {
  std::optional<GroundBounds> bounds;
  for_points(plan, [&](const glm::vec2& point) {
    if (!bounds) bounds = {point, point};
    add_to(*bounds, point);
  });
  return bounds;
}

GroundBounds bounds_of(const Trajectories& trajectories) {
  constexpr float far = std::numeric_limits<float>::max();
  GroundBounds bounds{.low = glm::vec2(far), .high = glm::vec2(-far)};
  if (trajectories.is_live) {
    bounds = bounds_of(trajectories.plan).value_or(GroundBounds{glm::vec2(-around_first), glm::vec2(around_first)});
  }
  for (const PersonTrack& person : trajectories.persons) {
    for (const TrackRow& row : person.rows) add_to(bounds, row);
  }
  return bounds;
}

}  // namespace throng
