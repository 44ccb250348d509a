#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/times.h"

namespace throng::app {

/// Something that is timed once a round.
struct BenchSubject {
  std::string key;
  std::function<void()> run;
  std::function<void()> prepare = [] {};  ///< before it, untimed
};

/// Subjects that take turns, so that a drift of the machine's speed meets all of them alike. What ran before leaves its
/// mark on caches and clock rates for some milliseconds, so each runs untimed for as long first: a frame is timed
/// among frames.
class BenchRounds {
 public:
  void add(BenchSubject subject) { subjects_.push_back(std::move(subject)); }

  /// After a round to warm up. `label` stands before the count of rounds, for a person at a terminal.
  void run(int rounds, const std::string& label);

  const BenchTimes& times() const { return times_; }

 private:
  std::vector<BenchSubject> subjects_;
  BenchTimes times_;
};

/// Rewrites its own line on standard error, and only where that is a terminal; an empty text clears it.
void show_progress(const std::string& text);

}  // namespace throng::app
