#include "tests/benchmark/programs/least_squares.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::least_squares_test {
namespace {

TEST(LeastSquares, FindsTheCoefficientsThatMadeTheValues) {
  const std::vector<double> made_with = {3.0, 0.5, 20.0};
  LeastSquares fit(3);
  for (int i = 0; i < 12; ++i) {
    const std::vector<double> parts = {1.0 + i, std::sin(i) + 2, i % 3 == 0 ? 1.0 : 0.0};
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) value += parts[k] * made_with[k];
    fit.add(parts, value, 1.0 / value);
  }
  const std::vector<double> found = fit.solve_without_negatives();
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], made_with[k], 1e-6);
}

TEST(LeastSquares, HoldsAtZeroWhatWouldBeNegative) {
  LeastSquares fit(2);
  for (int i = 1; i < 9; ++i) fit.add({static_cast<double>(i), 1.0}, 5.0 * i - 3.0, 1.0);
  const std::vector<double> found = fit.solve_without_negatives();
  EXPECT_EQ(found[1], 0.0);
  EXPECT_NEAR(found[0], 4.5, 0.2);
}

TEST(LeastSquares, LeavesAtZeroWhatNoSampleHas) {
  LeastSquares fit(2);
  fit.add({2.0, 0.0}, 6.0, 1.0);
  EXPECT_EQ(fit.solve_without_negatives(), (std::vector<double>{3.0, 0.0}));
}

}  // namespace
}  // namespace throng::app::least_squares_test
