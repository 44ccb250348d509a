#include "tests/benchmark/programs/least_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace throng::app {

void LeastSquares::add(const std::vector<double>& parts, double value, double weight) {
  const double squared = weight * weight;
  for (std::size_t row = 0; row < count_; ++row) {
    for (std::size_t column = 0; column < count_; ++column) {
      products_[row * count_ + column] += squared * parts[row] * parts[column];
    }
    values_[row] += squared * parts[row] * value;
  }
}

// Gauss and Jordan, the largest pivot first.
std::vector<double> LeastSquares::solve(const std::vector<bool>& held_at_zero) const {
  std::vector<double> matrix = products_, right = values_;
  std::vector<double> result(count_, 0.0);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count_; ++i) {
    if (!held_at_zero[i] && matrix[i * count_ + i] > 0.0) order.push_back(i);
  }
  for (std::size_t step = 0; step < order.size(); ++step) {
    const auto pivot = std::max_element(order.begin() + static_cast<std::ptrdiff_t>(step), order.end(),
                                        [&](std::size_t a, std::size_t b) {
                                          return std::abs(matrix[a * count_ + a]) < std::abs(matrix[b * count_ + b]);
                                        });
    std::iter_swap(order.begin() + static_cast<std::ptrdiff_t>(step), pivot);
    const std::size_t row = order[step];
    if (std::abs(matrix[row * count_ + row]) < 1e-12 * std::abs(products_[row * count_ + row])) continue;
    for (const std::size_t other : order) {
      if (other == row) continue;
      const double factor = matrix[other * count_ + row] / matrix[row * count_ + row];
      for (const std::size_t column : order) {
        matrix[other * count_ + column] -= factor * matrix[row * count_ + column];
      }
      right[other] -= factor * right[row];
    }
  }
  for (const std::size_t row : order) {
    const double pivot = matrix[row * count_ + row];
    if (std::abs(pivot) >= 1e-12 * std::abs(products_[row * count_ + row])) result[row] = right[row] / pivot;
  }
  return result;
}

std::vector<double> LeastSquares::solve_without_negatives() const {
  std::vector<bool> held_at_zero(count_, false);
  while (true) {
    std::vector<double> result = solve(held_at_zero);
    const auto lowest = std::ranges::min_element(result);
    if (lowest == result.end() || *lowest >= 0.0) return result;
    held_at_zero[static_cast<std::size_t>(lowest - result.begin())] = true;
  }
}

}  // namespace throng::app
