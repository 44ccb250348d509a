#include "engine/anim/base/elementary.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace throng::anim {
namespace {

/// Returns terms[0] + terms[1] x + terms[2] x^2 ...
template <std::size_t count>
double polynomial(const std::array<double, count>& terms, double x) {
  double sum = terms.back();
  for (std::size_t i = count - 1; i-- > 0;) sum = sum * x + terms[i];
  return sum;
}

/// Quarter turns, and the rest of an angle: an eighth of a turn at most, as a double and its rounding error.
struct Reduced {
  int quarters = 0;
  double rest = 0.0;
  double below = 0.0;
};

// pi / 2 in three parts. The first two have 33 bits each, so that products with up to 20 bits are exact.
constexpr double half_pi_high = 0x1.921fb544p+0;
constexpr double half_pi_middle = 0x1.0b4611a6p-34;
constexpr double half_pi_low = 0x1.3198a2e037073p-69;
constexpr double most_exact = 1e6;  // so many quarters have 20 bits

Reduced reduced(double angle) {
  if (!(std::abs(angle) <= most_exact)) angle = std::remainder(angle, 2.0 * std::numbers::pi);
  if (std::isnan(angle)) return {.rest = angle};
  const double quarters = std::floor(angle * (2.0 / std::numbers::pi) + 0.5);
  if (quarters == 0.0) return {.rest = angle};
  const double first = angle - quarters * half_pi_high;
  const double middle = quarters * half_pi_middle;
  const double nearly = first - middle;
  const double lost = (first - nearly - middle) - quarters * half_pi_low;
  const double rest = nearly + lost;
  return {.quarters = static_cast<int>(quarters), .rest = rest, .below = nearly - rest + lost};
}

/// Taylor's series, to the precision of a double. The sum of `x` and `below` is an eighth of a turn at most.
double short_sine(double x, double below) {
  static constexpr std::array terms{
      -1.0 / 6.0,        1.0 / 120.0,        -1.0 / 5040.0,          1.0 / 362880.0,
      -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0};
  if (x == 0.0) return x;  // with its sign
  const double square = x * x;
  return x + (x * square * polynomial(terms, square) + below * (1.0 - 0.5 * square));
}

double short_cosine(double x, double below) {
  static constexpr std::array terms{1.0 / 24.0,        -1.0 / 720.0,         1.0 / 40320.0,         -1.0 / 3628800.0,
                                    1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0};
  const double square = x * x;
  const double half = 0.5 * square;
  const double most = 1.0 - half;
  return most + ((1.0 - most - half) + (square * square * polynomial(terms, square) - x * below));
}

double sine_of(const Reduced& angle, int more_quarters) {
  const int quadrant = (angle.quarters + more_quarters) & 3;
  const bool across = quadrant % 2 != 0;
  const double value = across ? short_cosine(angle.rest, angle.below) : short_sine(angle.rest, angle.below);
  return quadrant < 2 ? value : -value;
}

/// Returns that sine in the precision of floats.
float rough_sine_of(const Reduced& angle, int more_quarters) {
  static constexpr std::array sine_terms{1.0, -0.16666654943701085, 0.0083321781461389207, -0.00019517298981394866};
  static constexpr std::array cosine_terms{1.0, -0.49999999725108225, 0.041666623324344657, -0.001388676379438055,
                                           2.439045070398962e-5};
  const int quadrant = (angle.quarters + more_quarters) & 3;
  const bool across = quadrant % 2 != 0;
  const double square = angle.rest * angle.rest;
  const double value = across ? polynomial(cosine_terms, square) : angle.rest * polynomial(sine_terms, square);
  return static_cast<float>(quadrant < 2 ? value : -value);
}

/// Returns the angle of a slope from 0 to 1: of up / along.
double angle_of_slope(double up, double along) {
  // The series of a slope of a quarter at most, past a known angle: the angle of slope 0, 1/2 or 1.
  static constexpr std::array terms{-1.0 / 3.0,  1.0 / 5.0,  -1.0 / 7.0,  1.0 / 9.0,  -1.0 / 11.0, 1.0 / 13.0,
                                    -1.0 / 15.0, 1.0 / 17.0, -1.0 / 19.0, 1.0 / 21.0, -1.0 / 23.0, 1.0 / 25.0};
  struct Known {
    double slope, angle, rounded_away;
  };
  static constexpr std::array known{Known{0.0, 0.0, 0.0}, Known{0.5, 0.4636476090008061, 2.2698777452961687e-17},
                                    Known{1.0, 0.7853981633974483, 3.061616997868383e-17}};
  const Known& start = known[up <= 0.25 * along ? 0 : up <= 0.75 * along ? 1 : 2];
  const double x = (up - start.slope * along) / (along + start.slope * up);
  const double square = x * x;
  return start.angle + (x + (start.rounded_away + x * square * polynomial(terms, square)));
}

template <typename Turn, typename Number, typename Axis>
Turn turn_about(Number angle, const Axis& axis) {
  const Number half = angle * Number{0.5};
  return Turn(cosine(half), axis * sine(half));
}

}  // namespace

float sine(float angle) { return rough_sine_of(reduced(static_cast<double>(angle)), 0); }
float cosine(float angle) { return rough_sine_of(reduced(static_cast<double>(angle)), 1); }
double sine(double angle) { return sine_of(reduced(angle), 0); }
double cosine(double angle) { return sine_of(reduced(angle), 1); }

double arc_tangent(double y, double x) {
  constexpr double half_pi = 0.5 * std::numbers::pi, rounded_away = 6.123233995736766e-17;
  const double up = std::abs(y), along = std::abs(x);
  double angle = 0.0;
  if (up > along) {
    const double from_upright = angle_of_slope(along, up);
    angle = half_pi + (rounded_away + (x < 0.0 ? from_upright : -from_upright));
  } else {
    if (along > 0.0) angle = angle_of_slope(up, along);
    if (std::signbit(x)) angle = 2.0 * half_pi + (2.0 * rounded_away - angle);
  }
  return std::copysign(angle, y);
}

double arc_cosine(double cosine) { return arc_tangent(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine); }

double cube_root(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  int exponent = 0;
  double part = std::frexp(std::abs(value), &exponent);
  for (; exponent % 3 != 0; ++exponent) part *= 0.5;
  double root = 0.46 + 0.57 * part;  // off by less than 7%, and Newton's steps square the error
  for (int i = 0; i < 5; ++i) root -= (root - part / (root * root)) / 3.0;
  return std::copysign(std::ldexp(root, exponent / 3), value);
}

glm::quat angle_axis(float angle, const glm::vec3& axis) { return turn_about<glm::quat>(angle, axis); }
glm::dquat angle_axis(double angle, const glm::dvec3& axis) { return turn_about<glm::dquat>(angle, axis); }

}  // namespace throng::anim
