#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "throng/host.h"

#include "app/people/crowd/crowd.h"
#include "app/people/measure/voronoi_density.h"
#include "app/people/measure/walkable_area.h"
#include "app/settings/settings.h"

namespace throng::app {

/// Measures each person of a crowd for the view in force: speed, density or time since appearing.
class CrowdMeasures {
 public:
  /// Measures the crowd as it is now; nothing where the view shows no measure. Allocates when another view begins.
  void take(const Crowd& crowd, const Tuning& tuning, Executor& executor, int jobs);

  /// Returns metres a second, people a square metre or seconds; below 0: unknown, or nothing was measured.
  float of(std::size_t agent) const { return agent < values_.size() ? values_[agent] : -1.0F; }

 private:
  void take_densities(const Crowd& crowd, float cut_off, Executor& executor, int jobs);

  std::vector<float> values_;  // [agent]
  VoronoiDensity density_;
  WalkableArea area_;
  std::shared_ptr<const Trajectories> area_of_;  // null: everywhere
};

/// Returns the speed of a person of a recorded crowd, metres a second: the mean over TrackSteps::stride_window, or over
/// a longer `window` in seconds, or the part of it in which the person is there, as a file's rows say it.
float speed_of(const Followers& followers, std::size_t agent, double seconds, double window = 0.0);

}  // namespace throng::app
