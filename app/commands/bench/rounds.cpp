#include "app/commands/bench/rounds.h"

#include <algorithm>
#include <chrono>

#include "app/files/progress_line.h"
#include "app/show/figures/statistics.h"

namespace throng::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int warm_up_rounds = 1;
constexpr std::chrono::milliseconds settling_time(10);

void settle(const BenchSubject& subject) {
  const auto start = Clock::now();
  do subject.run();
  while (Clock::now() - start < settling_time);
}

double time(const BenchSubject& subject) {
  subject.prepare();
  settle(subject);
  const auto start = Clock::now();
  subject.run();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

}  // namespace

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

void BenchRounds::run(int rounds, const std::string& label) {
  for (int round = -warm_up_rounds; round < rounds; ++round) {
    show_progress(label + "round " + std::to_string(std::max(round + 1, 0)) + " of " + std::to_string(rounds));
    for (const BenchSubject& subject : subjects_) {
      const double nanoseconds = time(subject);
      if (round >= 0) times_.add(subject.key, nanoseconds);
    }
  }
  show_progress("");
}

}  // namespace throng::app
