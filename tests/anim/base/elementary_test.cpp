// Each function against the same one in `long double`, over a sweep. Errors are in units in the last place of the
// result.
#include "engine/anim/base/elementary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/base/hash.h"

namespace throng::anim::elementary_test {
namespace {

template <typename Number>
long double error_of(Number value, long double exact) {
  const int digits = std::numeric_limits<Number>::digits;
  return std::abs(static_cast<long double>(value) - exact) / std::ldexp(1.0L, std::ilogb(exact) + 1 - digits);
}

/// The largest error among 100,000 numbers from `low` to `high`.
template <typename Number>
long double worst(Number (*ours)(Number), long double (*exact)(long double), Number low, Number high) {
  constexpr int steps = 100'000;
  long double most = 0.0L;
  for (int i = 0; i <= steps; ++i) {
    const Number at = low + (high - low) * (static_cast<Number>(i) / Number{steps});
    const long double right = exact(static_cast<long double>(at));
    if (right != 0.0L) most = std::max(most, error_of(ours(at), right));
  }
  return most;
}

/// Returns whether the system's sines of long doubles can measure ours. Those of MinGW take the processor's fsin, whose
/// pi has 66 bits.
bool has_exact_sines() {
  volatile long double angle = 3.141592653589793115997963L;  // the double that is nearest to pi
  return std::abs(std::sin(angle) / 1.2246467991473531772e-16L - 1.0L) < 1e-12L;
}

long double exact_sine(long double angle) { return std::sin(angle); }
long double exact_cosine(long double angle) { return std::cos(angle); }

TEST(Elementary, SinesOfDoublesAreOffByOneUnitAtMost) {
  if (!has_exact_sines()) GTEST_SKIP() << "the system's own sines of long doubles are not exact";
  for (const double far : {0.8, 7.0, 1000.0, 1e6}) {
    EXPECT_LT(worst<double>(sine, exact_sine, -far, 0.997 * far), 0.8L) << far;
    EXPECT_LT(worst<double>(cosine, exact_cosine, -far, 0.997 * far), 0.8L) << far;
  }
}

TEST(Elementary, SinesOfFloatsAreOffByLittleMoreThanTheirRounding) {
  for (const float far : {0.8F, 7.0F, 1000.0F}) {
    EXPECT_LT(worst<float>(sine, exact_sine, -far, 0.997F * far), 0.57L) << far;
    EXPECT_LT(worst<float>(cosine, exact_cosine, -far, 0.997F * far), 0.57L) << far;
  }
}

TEST(Elementary, SinesAreAsGoodWhereTheyAreNearlyZero) {
  if (!has_exact_sines()) GTEST_SKIP() << "the system's own sines of long doubles are not exact";
  for (int quarters = 1; quarters < 600'000; quarters += 7) {
    const double angle = quarters * (std::numbers::pi / 2.0);
    const auto exact = static_cast<long double>(angle);
    const bool odd = quarters % 2 != 0;
    ASSERT_LT(error_of(odd ? cosine(angle) : sine(angle), odd ? std::cos(exact) : std::sin(exact)), 0.8L) << quarters;
  }
}

TEST(Elementary, SinesBeyondAMillionAreThoseOfAnAngleNearby) {
  for (double angle = 1.5e6; angle < 1e15; angle *= 3.7) {
    const double off = 5e-17 * angle;
    EXPECT_NEAR(sine(angle), static_cast<double>(std::sin(static_cast<long double>(angle))), off) << angle;
    EXPECT_NEAR(cosine(angle), static_cast<double>(std::cos(static_cast<long double>(angle))), off) << angle;
  }
  EXPECT_LE(std::abs(sine(1e300)), 1.0);
  EXPECT_TRUE(std::isnan(sine(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(cosine(std::numeric_limits<float>::quiet_NaN())));
}

TEST(Elementary, ArcsAreOffByTwoUnitsAtMost) {
  const auto above = [](double slope) { return arc_tangent(slope, 1.0); };
  const auto behind = [](double slope) { return arc_tangent(slope, -1.0); };
  EXPECT_LT(worst<double>(
                above, [](long double slope) { return std::atan2(slope, 1.0L); }, -4.0, 4.01),
            1.5L);
  EXPECT_LT(worst<double>(
                behind, [](long double slope) { return std::atan2(slope, -1.0L); }, -4.0, 4.01),
            1.5L);
  EXPECT_LT(worst<double>(
                arc_cosine, [](long double cosine) { return std::acos(cosine); }, -1.0, 1.0),
            2.0L);
}

TEST(Elementary, ArcsKnowTheAxesAndTheOrigin) {
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(arc_tangent(0.0, 1.0), 0.0);
  EXPECT_EQ(arc_tangent(1.0, 0.0), pi / 2.0);
  EXPECT_EQ(arc_tangent(-1.0, 0.0), -pi / 2.0);
  EXPECT_EQ(arc_tangent(0.0, -1.0), pi);
  EXPECT_EQ(arc_tangent(-0.0, -1.0), -pi);
  EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
  EXPECT_EQ(arc_cosine(1.0), 0.0);
  EXPECT_EQ(arc_cosine(0.0), pi / 2.0);
  EXPECT_EQ(arc_cosine(-1.0), pi);
}

TEST(Elementary, CubeRootsAreOffByOneUnitAtMost) {
  EXPECT_LT(worst<double>(
                cube_root, [](long double value) { return std::cbrt(value); }, -9.0, 8.7),
            0.8L);
  EXPECT_EQ(cube_root(27e300), 3e100);
  EXPECT_EQ(cube_root(-8.0), -2.0);
  EXPECT_EQ(cube_root(0.0), 0.0);
}

TEST(Elementary, HasTheSameBitsOnEverySystem) {
  std::uint64_t hash = 0;
  const auto add = [&hash](double value) { hash = chain_hash(hash, std::bit_cast<std::uint64_t>(value)); };
  for (int i = -2000; i <= 2000; ++i) {
    const double at = 0.0173 * i;
    const auto rough = static_cast<float>(at);
    for (const float value : {sine(rough), cosine(rough)}) add(static_cast<double>(value));
    for (const double value : {sine(at), cosine(at), arc_tangent(at, 1.7), arc_cosine(i / 2000.0), cube_root(at)}) {
      add(value);
    }
  }
  EXPECT_EQ(hash, 0xa93df6f5a4fee743U);
}

TEST(Elementary, SineKeepsTheSignOfZero) {
  EXPECT_TRUE(std::signbit(sine(-0.0)));
  EXPECT_TRUE(std::signbit(sine(-0.0F)));
}

TEST(Elementary, TurnsAboutAnAxis) {
  const glm::dquat turn = angle_axis(std::numbers::pi / 3.0, glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_NEAR(turn.w, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(turn.y, 0.5, 1e-15);
  EXPECT_EQ(turn.x, 0.0);
}

}  // namespace
}  // namespace throng::anim::elementary_test
