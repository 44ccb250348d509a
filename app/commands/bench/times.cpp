#include "app/commands/bench/times.h"

#include <algorithm>

#include "app/show/figures/statistics.h"

namespace throng::app {

void BenchTimes::append(const BenchTimes& later) {
  for (const auto& [key, times] : later.rounds_) {
    std::vector<double>& mine = rounds_[key];
    mine.insert(mine.end(), times.begin(), times.end());
  }
}

double BenchTimes::median(const std::string& key) const { return has(key) ? app::median(rounds_.at(key)) : 0.0; }

double BenchTimes::fastest(const std::string& key) const {
  return has(key) ? *std::ranges::min_element(rounds_.at(key)) : 0.0;
}

double BenchTimes::median_ratio(const std::string& key, const BenchTimes& others, const std::string& other) const {
  if (!has(key) || !others.has(other)) return 0.0;
  const std::vector<double>&times = rounds_.at(key), &divisors = others.rounds_.at(other);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(times.size(), divisors.size()); ++round) {
    ratios.push_back(times[round] / divisors[round]);
  }
  return app::median(std::move(ratios));
}

}  // namespace throng::app
