#include "app/lod_thresholds.h"

#include <algorithm>
#include <cmath>

namespace throng::app {

int interval_at(const Tuning& tuning, float metres) {
  if (tuning.lod != LodRule::distance || metres < tuning.full_rate_distance) return 1;
  const float beyond = std::floor((metres - tuning.full_rate_distance) / tuning.interval_growth);
  return std::clamp(2 + static_cast<int>(beyond), 1, tuning.largest_interval);
}

std::vector<IntervalThreshold> interval_thresholds(const Tuning& tuning) {
  std::vector<IntervalThreshold> thresholds;
  if (tuning.lod != LodRule::distance) return thresholds;
  for (int interval = 2; interval <= tuning.largest_interval; ++interval) {
    const float steps = static_cast<float>(interval - 2);
    thresholds.push_back({tuning.full_rate_distance + steps * tuning.interval_growth, interval});
  }
  return thresholds;
}

}  // namespace throng::app
