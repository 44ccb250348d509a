#include "app/bench_rounds.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <unistd.h>

#include "app/statistics.h"

namespace throng::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int warm_up_rounds = 2;
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

void BenchRounds::run(int rounds, const std::string& label) {
  for (int round = -warm_up_rounds; round < rounds; ++round) {
    show_progress(label + "round " + std::to_string(std::max(round + 1, 0)) + " of " + std::to_string(rounds));
    for (Timed& timed : subjects_) {
      const double nanoseconds = time(timed.subject);
      if (round >= 0) timed.nanoseconds.push_back(nanoseconds);
    }
  }
  show_progress("");
}

const std::vector<double>* BenchRounds::times_of(const std::string& key) const {
  const auto found = std::ranges::find(subjects_, key, [](const Timed& timed) { return timed.subject.key; });
  return found == subjects_.end() ? nullptr : &found->nanoseconds;
}

double BenchRounds::median(const std::string& key) const {
  const std::vector<double>* times = times_of(key);
  return times == nullptr ? 0.0 : app::median(*times);
}

double BenchRounds::fastest(const std::string& key) const {
  const std::vector<double>* times = times_of(key);
  return times == nullptr || times->empty() ? 0.0 : *std::ranges::min_element(*times);
}

double BenchRounds::median_ratio(const std::string& key, const std::string& other) const {
  const std::vector<double>* times = times_of(key);
  const std::vector<double>* others = times_of(other);
  if (times == nullptr || others == nullptr) return 0.0;
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times->size(); ++round) ratios.push_back((*times)[round] / (*others)[round]);
  return app::median(std::move(ratios));
}

void show_progress(const std::string& text) {
  constexpr int width = 78;
  if (isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, text.empty() ? "\r%-*.*s\r" : "\r%-*.*s", width, width, text.c_str());
}

}  // namespace throng::app
