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
  std::function<void()> prepare = [] {};  ///< runs before it, untimed
};

/// Times subjects in turns, so that a drift of the machine's speed meets all of them alike. Earlier work leaves its
/// mark on caches and clock rates for some milliseconds, so each subject first runs untimed for as long.
class BenchRounds {
 public:
  void add(BenchSubject subject) { subjects_.push_back(std::move(subject)); }

  /// Times `rounds` rounds after one to warm up. At a terminal, `label` and the count of rounds are shown.
  void run(int rounds, const std::string& label);

  const BenchTimes& times() const { return times_; }

 private:
  std::vector<BenchSubject> subjects_;
  BenchTimes times_;
};

}  // namespace throng::app
