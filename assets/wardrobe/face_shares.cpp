#include "assets/wardrobe/face_shares.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::wardrobe {
namespace {

using glm::dvec3;

double bump_on_face(dvec3 place, dvec3 centre, dvec3 radius) {
  const dvec3 offset = (dvec3(std::abs(place.x), place.y, place.z) - centre) / radius;
  return std::exp(-glm::dot(offset, offset));
}

}  // namespace

glm::dvec4 face_shares(dvec3 p) {
  const double jaw = std::min(1.0, bump_on_face(p, {0.052, 1.592, 0.035}, {0.025, 0.028, 0.045}) +
                                       0.8 * bump_on_face(p, {0.0, 1.568, 0.085}, {0.030, 0.022, 0.035}));
  const double nose = bump_on_face(p, {0.0, 1.644, 0.116}, {0.016, 0.022, 0.022});
  const double brow = bump_on_face(p, {0.030, 1.706, 0.094}, {0.034, 0.013, 0.030});
  const double apart = bump_on_face(p, {0.033, 1.677, 0.080}, {0.024, 0.020, 0.045});
  return {jaw, nose, brow, std::copysign(apart, p.x)};
}

}  // namespace throng::wardrobe
