#include "assets/wardrobe/head_warp.h"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/curve.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::CurveKey;
using mannequin::open_curve;

const dvec3 head_joint(0, 1.565, -0.008);

/// A soft bump around a place on the left, and on the right its image; 1 in the middle.
double on_both_sides(dvec3 place, dvec3 centre, dvec3 radius) {
  const dvec3 offset = (dvec3(std::abs(place.x), place.y, place.z) - centre) / radius;
  return std::exp(-glm::dot(offset, offset));
}

/// Returns where a place goes when all around `centre` grows by a share, on both sides of the face.
dvec3 grown(dvec3 p, dvec3 there, dvec3 centre, double radius, double share) {
  const dvec3 middle(std::copysign(centre.x, p.x), centre.y, centre.z);
  return there + (p - middle) * (share * on_both_sides(p, centre, dvec3(radius)));
}

const dvec3 eye(0.0325, 1.6775, 0.080);

dvec3 woman(dvec3 p) {
  // A narrower jaw and a shorter chin.
  constexpr std::array<CurveKey, 5> width{{{1.545, 0.86}, {1.59, 0.85}, {1.64, 0.955}, {1.69, 0.965}, {1.80, 0.965}}};
  const double front = glm::smoothstep(-0.03, 0.04, p.z);
  const double factor = glm::mix(0.95, open_curve(width, p.y), front);
  dvec3 there(p.x * factor, p.y, head_joint.z + (p.z - head_joint.z) * 0.965);
  there = grown(p, there, eye, 0.026, 0.13);
  there = grown(p, there, {0, 1.606, 0.092}, 0.020, 0.12) -
          dvec3(0.10 * p.x * on_both_sides(p, {0, 1.606, 0.092}, dvec3(0.024)), 0, 0);
  there.x -= 0.20 * p.x * on_both_sides(p, {0, 1.640, 0.108}, {0.03, 0.022, 0.04});
  there.y += 0.003 * on_both_sides(p, {0.035, 1.703, 0.09}, {0.04, 0.010, 0.04});
  there.y += 0.004 * on_both_sides(p, {0, 1.565, 0.08}, {0.04, 0.03, 0.05});
  there.z -= 0.003 * on_both_sides(p, {0, 1.706, 0.10}, {0.05, 0.012, 0.03});
  there.z -= 0.004 * on_both_sides(p, {0, 1.645, 0.118}, {0.02, 0.02, 0.03});
  return there;
}

dvec3 child(dvec3 p) {
  constexpr double scale = 1.5;
  // Places above the chin move down: a child has a high forehead, low eyes and a small jaw.
  constexpr std::array<CurveKey, 7> height{
      {{1.50, 1.52}, {1.557, 1.572}, {1.606, 1.603}, {1.63, 1.621}, {1.677, 1.656}, {1.72, 1.707}, {1.79, 1.79}}};
  constexpr std::array<CurveKey, 6> width{
      {{1.545, 0.76}, {1.59, 0.92}, {1.63, 1.08}, {1.68, 1.05}, {1.72, 1.0}, {1.80, 0.98}}};
  const double front = glm::smoothstep(-0.05, 0.03, p.z);
  const double low = p.y < 1.50 ? p.y + 0.02 : p.y > 1.79 ? p.y : open_curve(height, p.y);
  dvec3 there(p.x * glm::mix(1.0, open_curve(width, p.y), front), glm::mix(p.y, low, glm::mix(0.4, 1.0, front)), p.z);
  there = grown(p, there, eye, 0.026, 0.20);
  there.x *= 1 - 0.24 * on_both_sides(p, {0, 1.640, 0.11}, {0.03, 0.020, 0.05}) -
             0.16 * on_both_sides(p, {0, 1.606, 0.09}, {0.05, 0.016, 0.05});
  there.z -= 0.011 * on_both_sides(p, {0, 1.645, 0.118}, {0.022, 0.022, 0.03});
  there.z -= 0.0055 * on_both_sides(p, {0, 1.672, 0.105}, {0.012, 0.020, 0.03});
  there.z += 0.0030 * on_both_sides(p, {0.038, 1.628, 0.085}, {0.020, 0.018, 0.05});
  there.z -= 0.004 * on_both_sides(p, {0, 1.565, 0.09}, {0.03, 0.02, 0.04});
  return head_joint + (there - head_joint) * scale;
}

}  // namespace

dvec3 head_warped(Body body, dvec3 place) {
  if (body == Body::woman) return woman(place);
  return body == Body::child ? child(place) : place;
}

}  // namespace throng::wardrobe
