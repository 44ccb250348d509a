#pragma once

#include <map>
#include <string>
#include <vector>

namespace throng::app {

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

}  // namespace throng::app
