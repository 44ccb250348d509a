#include "app/commands/bench/times.h"

#include <algorithm>

#include "app/figures/statistics.h"

namespace throng::app {

void BenchTimes::add(const std::string& key, double nanoseconds) {
  auto found = std::ranges::find(subjects_, key, [](const auto& subject) { return subject.first; });
  if (found == subjects_.end()) found = subjects_.insert(found, {key, {}});
  found->second.push_back(nanoseconds);
}

void BenchTimes::append(const BenchTimes& later) {
  for (const auto& [key, times] : later.subjects_) {
    for (const double nanoseconds : times) add(key, nanoseconds);
  }
}

const std::vector<double>* BenchTimes::of(const std::string& key) const {
  const auto found = std::ranges::find(subjects_, key, [](const auto& subject) { return subject.first; });
  return found == subjects_.end() ? nullptr : &found->second;
}

double BenchTimes::median(const std::string& key) const {
  const std::vector<double>* times = of(key);
  return times == nullptr ? 0.0 : app::median(*times);
}

double BenchTimes::fastest(const std::string& key) const {
  const std::vector<double>* times = of(key);
  return times == nullptr ? 0.0 : *std::ranges::min_element(*times);
}

double BenchTimes::median_ratio(const std::string& key, const BenchTimes& others, const std::string& other) const {
  const std::vector<double>* times = of(key);
  const std::vector<double>* divisors = others.of(other);
  if (times == nullptr || divisors == nullptr) return 0.0;
  std::vector<double> ratios;
  for (std::size_t round = 0; round < std::min(times->size(), divisors->size()); ++round) {
    ratios.push_back((*times)[round] / (*divisors)[round]);
  }
  return app::median(std::move(ratios));
}

}  // namespace throng::app
