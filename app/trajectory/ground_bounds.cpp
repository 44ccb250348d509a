#include "app/trajectory/ground_bounds.h"

#include <limits>

namespace throng::app {
namespace {

constexpr float around_first = 4.0F;  // metres

}  // namespace

GroundBounds bounds_of(const Trajectories& trajectories) {
  constexpr float far = std::numeric_limits<float>::max();
  GroundBounds bounds{.low = glm::vec2(far), .high = glm::vec2(-far)};
  if (trajectories.is_live) {
    for_points(trajectories.plan, [&](const glm::vec2& point) { add_to(bounds, point); });
    if (bounds.low.x > bounds.high.x) bounds = {glm::vec2(-around_first), glm::vec2(around_first)};
  }
  for (const PersonTrack& person : trajectories.persons) {
    for (const TrackRow& row : person.rows) add_to(bounds, row);
  }
  return bounds;
}

}  // namespace throng::app
