#pragma once

#include <cmath>

#include <glm/vec2.hpp>

namespace throng::app {

/// Returns the area of the parallelogram of two directions; below 0 where `b` lies to the right of `a`, with x to the
/// right and y up.
template <typename Vector>
typename Vector::value_type cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

/// Returns the cosine and sine of `quarters` quarter turns, within 1e-15. It uses exact operations alone, because the
/// functions of the C library differ in the last bit from machine to machine.
inline glm::dvec2 cosine_sine(double quarters) {
  const double whole = std::floor(quarters);
  const double angle = (quarters - whole) * 1.5707963267948966;
  const double square = angle * angle;
  double cosine = 1.0, sine = 1.0;
  for (int order = 20; order > 0; order -= 2) {  // nested Taylor series
    cosine = 1.0 - cosine * square / (order * (order - 1));
    sine = 1.0 - sine * square / (order * (order + 1));
  }
  sine *= angle;
  switch (static_cast<long long>(whole) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace throng::app
