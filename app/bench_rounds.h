#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

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
  void add(BenchSubject subject) { subjects_.push_back({std::move(subject), {}}); }

  /// After some rounds to warm up. `label` stands before the count of rounds, for a person at a terminal.
  void run(int rounds, const std::string& label);

  bool has(const std::string& key) const { return times_of(key) != nullptr; }
  /// Nanoseconds of one run; 0 if there is no such subject.
  double median(const std::string& key) const;
  double fastest(const std::string& key) const;
  /// Of one run of `key` over one of `other`, round by round.
  double median_ratio(const std::string& key, const std::string& other) const;

 private:
  struct Timed {
    BenchSubject subject;
    std::vector<double> nanoseconds;
  };
  const std::vector<double>* times_of(const std::string& key) const;

  std::vector<Timed> subjects_;
};

/// Rewrites its own line on standard error, and only where that is a terminal; an empty text clears it.
void show_progress(const std::string& text);

}  // namespace throng::app
