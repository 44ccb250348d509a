#include "app/commands/bench/rounds.h"

#include <algorithm>
#include <chrono>

#include "app/files/progress_line.h"

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
