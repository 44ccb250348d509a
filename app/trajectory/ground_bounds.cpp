#include "app/trajectory/ground_bounds.h"

namespace throng::app {

GroundBounds bounds_of(const Trajectories& trajectories) {
  const TrackRow& first = trajectories.persons.front().rows.front();
  GroundBounds bounds{.low = {first.x, first.z}, .high = {first.x, first.z}};
  for (const PersonTrack& person : trajectories.persons) {
    for (const TrackRow& row : person.rows) {
      bounds.low = glm::min(bounds.low, glm::vec2(row.x, row.z));
      bounds.high = glm::max(bounds.high, glm::vec2(row.x, row.z));
    }
  }
  return bounds;
}

}  // namespace throng::app
