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

dvec3 woman(dvec3 p) {
  // A narrower jaw and a shorter chin.
  constexpr std::array<CurveKey, 5> width{{{1.545, 0.90}, {1.59, 0.88}, {1.64, 0.955}, {1.69, 0.965}, {1.80, 0.965}}};
  const double front = glm::smoothstep(-0.03, 0.04, p.z);
  const double factor = glm::mix(0.95, open_curve(width, p.y), front);
  dvec3 there(p.x * factor, p.y, head_joint.z + (p.z - head_joint.z) * 0.965);
  there.y += 0.004 * on_both_sides(p, {0, 1.565, 0.08}, {0.04, 0.03, 0.05});
  there.z -= 0.003 * on_both_sides(p, {0, 1.706, 0.10}, {0.05, 0.012, 0.03});
  there.z -= 0.004 * on_both_sides(p, {0, 1.645, 0.118}, {0.02, 0.02, 0.03});
  return there;
}

dvec3 child(dvec3 p) {
  constexpr double scale = 1.5;
  // What lies above the chin moves down: a high forehead, low eyes, a small jaw.
  constexpr std::array<CurveKey, 7> height{
      {{1.50, 1.52}, {1.557, 1.562}, {1.60, 1.592}, {1.64, 1.622}, {1.677, 1.660}, {1.72, 1.708}, {1.79, 1.79}}};
  constexpr std::array<CurveKey, 6> width{
      {{1.545, 0.86}, {1.59, 0.97}, {1.63, 1.06}, {1.68, 1.03}, {1.72, 1.0}, {1.80, 0.98}}};
  const double front = glm::smoothstep(-0.05, 0.03, p.z);
  const double low = p.y < 1.50 ? p.y + 0.02 : p.y > 1.79 ? p.y : open_curve(height, p.y);
  dvec3 there(p.x * glm::mix(1.0, open_curve(width, p.y), front), glm::mix(p.y, low, glm::mix(0.4, 1.0, front)), p.z);
  there.z -= 0.011 * on_both_sides(p, {0, 1.645, 0.118}, {0.022, 0.022, 0.03});
  there.z -= 0.004 * on_both_sides(p, {0, 1.565, 0.09}, {0.03, 0.02, 0.04});
  return head_joint + (there - head_joint) * scale;
}

}  // namespace

dvec3 head_warped(Body body, dvec3 place) {
  if (body == Body::woman) return woman(place);
  return body == Body::child ? child(place) : place;
}

}  // namespace throng::wardrobe
