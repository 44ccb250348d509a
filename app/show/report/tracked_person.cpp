#include "app/show/report/tracked_person.h"

#include <algorithm>
#include <cmath>

namespace throng::app {

float TrackedPerson::fastest() const { return *std::ranges::max_element(speeds); }

std::size_t TrackedPerson::steps_until(double seconds) const {
  const auto later = std::ranges::upper_bound(footfalls, seconds, {}, &Footfall::seconds);
  return static_cast<std::size_t>(later - footfalls.begin());
}

float TrackedPerson::at(const std::vector<float>& values, double seconds) const {
  const double length = presence.last - presence.first;
  const double share = length > 0.0 ? std::clamp((seconds - presence.first) / length, 0.0, 1.0) : 0.0;
  const double place = share * static_cast<double>(values.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), values.size() - 2);
  return std::lerp(values[before], values[before + 1], static_cast<float>(place - static_cast<double>(before)));
}

}  // namespace throng::app
