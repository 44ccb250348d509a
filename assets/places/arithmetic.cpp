#include "assets/places/arithmetic.h"

#include <cmath>

namespace throng::places {
namespace {

/// The sine of an angle of at most an eighth of a turn, in radians (Taylor).
double short_sine(double x) {
  const double s = x * x;
  return x * (1 - s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156))))));
}

double short_cosine(double x) {
  const double s = x * x;
  return 1 - s / 2 * (1 - s / 12 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132)))));
}

double linear_channel(std::uint32_t byte) {
  const double c = byte / 255.0;
  return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

}  // namespace

double sine(double turns) {
  turns -= std::floor(turns);
  const double quarters = turns * 4;
  const int nearest = static_cast<int>(std::floor(quarters + 0.5));
  const double rest = (quarters - nearest) * (pi / 2);
  switch (nearest % 4) {
    case 0:
      return short_sine(rest);
    case 1:
      return short_cosine(rest);
    case 2:
      return -short_sine(rest);
    default:
      return -short_cosine(rest);
  }
}

double cosine(double turns) { return sine(turns + 0.25); }

double chance(std::uint32_t seed, std::uint32_t index) {
  std::uint32_t x = seed * 0x9E3779B9U + index * 0x85EBCA6BU + 0x27D4EB2FU;
  x ^= x >> 15U;
  x *= 0x2C1B3C6DU;
  x ^= x >> 12U;
  x *= 0x297A2D39U;
  x ^= x >> 15U;
  return x / 4294967296.0;
}

glm::dvec3 rgb(std::uint32_t hex) {
  return {linear_channel(hex >> 16U & 255U), linear_channel(hex >> 8U & 255U), linear_channel(hex & 255U)};
}

}  // namespace throng::places
