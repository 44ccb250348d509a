#include "engine/anim/kernel/lanes/rotations.h"

#include <algorithm>
#include <cassert>
#include <numbers>

#include <glm/geometric.hpp>

namespace throng::anim {

namespace {

constexpr float shortest_length = 1e-12F;
constexpr float pi = std::numbers::pi_v<float>;

template <typename Find>
glm::vec3 unit_or_found(const glm::vec3& v, Find&& find) {
  const float largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (!is_finite(v) || largest < shortest_length) return find();
  // Scaled first, so that neither a tiny nor a huge vector is lost when it is squared.
  const glm::vec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// Taylor series, good to 6e-8 from -pi/2 to pi/2.
float sine(float x) {
  const float z = x * x;
  return x + x * z *
                 (-1.0F / 6.0F +
                  z * (1.0F / 120.0F + z * (-1.0F / 5040.0F + z * (1.0F / 362880.0F - z * (1.0F / 39916800.0F)))));
}

float cosine(float x) {
  const float z = x * x;
  return 1.0F +
         z * (-1.0F / 2.0F +
              z * (1.0F / 24.0F + z * (-1.0F / 720.0F +
                                       z * (1.0F / 40320.0F + z * (-1.0F / 3628800.0F + z * (1.0F / 479001600.0F))))));
}

/// Minimax polynomial of the Cephes library for 0 to tan(pi/8), after one reduction; 0 <= x <= 1.
float arc_tangent(float x) {
  const bool upper_half = x > 0.41421356F;
  const float reduced = upper_half ? (x - 1.0F) / (x + 1.0F) : x;
  const float z = reduced * reduced;
  const float series = (((8.05374449538e-2F * z - 1.38776856032e-1F) * z + 1.99777106478e-1F) * z - 3.33329491539e-1F);
  return (upper_half ? pi / 4.0F : 0.0F) + (series * z * reduced + reduced);
}

}  // namespace

bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  return unit_or_found(v, [&otherwise] { return otherwise; });
}

glm::vec3 unit_or_perpendicular(const glm::vec3& v, const glm::vec3& unit) {
  return unit_or_found(v, [&unit] { return any_perpendicular(unit); });
}

glm::vec3 any_perpendicular(const glm::vec3& unit) {
  const glm::vec3 axis = std::fabs(unit.x) < 0.6F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
  return unit_or(glm::cross(unit, axis), {0.0F, 0.0F, 1.0F});
}

glm::vec3 perpendicular_part(const glm::vec3& v, const glm::vec3& unit) { return v - unit * glm::dot(v, unit); }

glm::quat shortest_turn(const glm::vec3& from, const glm::vec3& to) { return limited_turn(from, to, -1.0F); }

glm::quat limited_turn(const glm::vec3& from, const glm::vec3& to, float least_cosine) {
  const float whole = std::clamp(glm::dot(from, to), -1.0F, 1.0F);
  const glm::vec3 crossed = glm::cross(from, to);
  if (whole >= least_cosine && whole > -0.9999F) {
    return glm::normalize(glm::quat(1.0F + whole, crossed.x, crossed.y, crossed.z));
  }
  // Half a turn, or as far as the limit: halves of a chord stay exact where a cosine near -1 does not.
  const glm::vec3 aside = any_perpendicular(from);
  const glm::vec3 axis = unit_or(perpendicular_part(unit_or(crossed, aside), from), aside);
  const bool limited = whole < least_cosine;
  const float half_cosine = limited ? std::sqrt((1.0F + least_cosine) / 2.0F) : glm::length(from + to) / 2.0F;
  const float half_sine = limited ? std::sqrt((1.0F - least_cosine) / 2.0F) : glm::length(to - from) / 2.0F;
  const glm::vec3 half_axis = axis * half_sine;
  return glm::normalize(glm::quat(half_cosine, half_axis.x, half_axis.y, half_axis.z));
}

glm::quat turn_about(const glm::vec3& axis, float radians) {
  assert(std::fabs(radians) <= pi * 1.0001F);
  const float half = radians * 0.5F;
  const glm::vec3 turned = axis * sine(half);
  return {cosine(half), turned.x, turned.y, turned.z};  // GLM takes w first
}

float angle_of(float y, float x) {
  const float width = std::fabs(x);
  const float height = std::fabs(y);
  const float longer = std::max(width, height);
  if (!(longer > 0.0F)) return 0.0F;
  const float acute = arc_tangent(std::min(width, height) / longer);
  const float from_axis = height > width ? pi / 2.0F - acute : acute;
  return std::copysign(x < 0.0F ? pi - from_axis : from_axis, y);
}

glm::quat mix_rotations(const glm::quat& from, const glm::quat& to, float weight) {
  const float side = glm::dot(from, to) < 0.0F ? -weight : weight;
  return glm::normalize(from * (1.0F - weight) + to * side);
}

}  // namespace throng::anim
