#pragma once

#include <cstddef>
#include <vector>

namespace throng::app {

/// Finds the coefficients that explain measured values best: the sum of part times coefficient is near the value for
/// each sample.
class LeastSquares {
 public:
  explicit LeastSquares(std::size_t coefficients)
      : count_(coefficients), products_(coefficients * coefficients, 0.0), values_(coefficients, 0.0) {}

  /// Adds a sample. `weight` is 1 / value if relative errors count.
  void add(const std::vector<double>& parts, double value, double weight);

  /// Returns the coefficients, none below 0. One that would be below is held at 0, and the others are found anew. One
  /// that no sample has is 0, too.
  std::vector<double> solve_without_negatives() const;

 private:
  std::vector<double> solve(const std::vector<bool>& held_at_zero) const;

  std::size_t count_;
  std::vector<double> products_;  // [coefficient][coefficient], of the normal equations
  std::vector<double> values_;    // [coefficient]
};

}  // namespace throng::app
