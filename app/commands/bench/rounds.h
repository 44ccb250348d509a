#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace throng::app {

/// Something that is timed once a round.
struct BenchSubject {
  std::string key;
  std::function<void()> run;
  std::function<void()> prepare = [] {};  ///< runs before it, untimed
};

/// The times that subjects took, round by round.
class BenchTimes {
 public:
  /// Adds the next round's time of one run of `key`.
  void add(const std::string& key, double nanoseconds) { rounds_[key].push_back(nanoseconds); }
  /// Puts the rounds of `later` behind these.
  void append(const BenchTimes& later);

  bool has(const std::string& key) const { return rounds_.contains(key); }
  /// Returns the median of the nanoseconds of one run; 0 if there is no such subject.
  double median(const std::string& key) const;
  double fastest(const std::string& key) const;
  /// Returns the median of the time of one run of `key` over one of `other`, round by round, as far as both were timed;
  /// 0 if either was not.
  double median_ratio(const std::string& key, const std::string& other) const {
    return median_ratio(key, *this, other);
  }
  double median_ratio(const std::string& key, const BenchTimes& others, const std::string& other) const;

 private:
  std::map<std::string, std::vector<double>> rounds_;  // nanoseconds by subject
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
