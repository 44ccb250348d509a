#include "app/trajectory/ground_bounds.h"

#include <limits>

namespace throng::app {
namespace {

constexpr float around_first = 4.0F;  // metres

void add_plan(const GroundPlan& plan, GroundBounds& bounds) {
  for (const GroundArea& area : plan.floors) {
    for (const glm::vec2& corner : area.outline) add_to(bounds, corner);
  }
  for (const GroundRing& obstacle : plan.obstacles) {
    for (const glm::vec2& corner : obstacle) add_to(bounds, corner);
  }
  for (const GroundLine& wall : plan.walls) {
    for (const glm::vec2& corner : wall.points) add_to(bounds, corner);
  }
}

}  // namespace

GroundBounds bounds_of(const Trajectories& trajectories) {
  constexpr float far = std::numeric_limits<float>::max();
  GroundBounds bounds{.low = glm::vec2(far), .high = glm::vec2(-far)};
  if (trajectories.is_live) {
    add_plan(trajectories.plan, bounds);
    if (bounds.low.x > bounds.high.x) bounds = {glm::vec2(-around_first), glm::vec2(around_first)};
  }
  for (const PersonTrack& person : trajectories.persons) {
    for (const TrackRow& row : person.rows) add_to(bounds, row);
  }
  return bounds;
}

}  // namespace throng::app
