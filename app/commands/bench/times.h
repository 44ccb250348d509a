#pragma once

#include <string>
#include <utility>
#include <vector>

namespace throng::app {

/// How long subjects took, round by round.
class BenchTimes {
 public:
  /// The next round's, of one run of `key`.
  void add(const std::string& key, double nanoseconds);
  /// The rounds of `later` behind these.
  void append(const BenchTimes& later);

  bool has(const std::string& key) const { return of(key) != nullptr; }
  /// Nanoseconds of one run; 0 if there is no such subject.
  double median(const std::string& key) const;
  double fastest(const std::string& key) const;
  /// Of one run of `key` over one of `other`, round by round, as far as both were timed; 0 if either was not.
  double median_ratio(const std::string& key, const std::string& other) const {
    return median_ratio(key, *this, other);
  }
  double median_ratio(const std::string& key, const BenchTimes& others, const std::string& other) const;

 private:
  const std::vector<double>* of(const std::string& key) const;

  std::vector<std::pair<std::string, std::vector<double>>> subjects_;  // few; key and nanoseconds
};

}  // namespace throng::app
