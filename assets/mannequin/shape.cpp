#include "assets/mannequin/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::mannequin {
namespace {

using glm::dvec2;
using glm::dvec3;

/// The shape of points that follow a joint, by the beginning of its name; the longest beginning counts.
struct JointShape {
  std::string_view begins;
  double stout, broad, stooped;
};
constexpr std::array<JointShape, 17> joint_shapes{{{"hips", 0.55, -0.45, 0.0},
                                                   {"spine", 0.70, 0.10, 0.10},
                                                   {"chest", 0.55, 0.35, 0.38},
                                                   {"upper_chest", 0.40, 0.35, 0.72},
                                                   {"neck", 0.22, 0.30, 0.95},
                                                   {"head", 0.05, 0.04, 1.0},
                                                   {"jaw", 0.14, 0.10, 1.0},
                                                   {"shoulder", 0.35, 0.80, 0.80},
                                                   {"upper_arm", 0.34, 0.30, 0.84},
                                                   {"upper_arm_twist", 0.38, 0.62, 0.84},
                                                   {"forearm", 0.22, 0.16, 0.84},
                                                   {"forearm_twist", 0.14, 0.10, 0.84},
                                                   {"thigh", 0.36, -0.22, 0.0},
                                                   {"thigh_twist", 0.44, -0.38, 0.0},
                                                   {"shin", 0.20, -0.05, 0.0},
                                                   {"foot", 0.0, 0.0, 0.0},
                                                   {"toe", 0.0, 0.0, 0.0}}};

dvec3 shape_of(std::string_view joint) {
  if (joint.starts_with("eye")) joint = "head";
  const JointShape* best = nullptr;
  for (const JointShape& shape : joint_shapes) {
    if (joint.starts_with(shape.begins) && (best == nullptr || shape.begins.size() > best->begins.size()))
      best = &shape;
  }
  const bool of_hand = best == nullptr && joint != "root";
  return best == nullptr ? dvec3(0.03, 0.0, of_hand ? 0.84 : 0.0) : dvec3(best->stout, best->broad, best->stooped);
}

/// A soft bump around a place, the same on both sides.
double bump(dvec3 place, dvec3 centre, dvec3 radius) {
  const dvec3 offset = (dvec3(std::abs(place.x), place.y, place.z) - centre) / radius;
  return std::exp(-glm::dot(offset, offset));
}

dvec3 body_shape(const SkinPoint& point) {
  dvec3 shape = shape_by_joints(point.weights);
  const dvec3 at = point.position;
  shape.x += 0.45 * bump(at, {0, 1.06, 0.10}, {0.13, 0.10, 0.09});
  shape.y -= 0.95 * bump(at, {0.072, 1.285, 0.115}, {0.052, 0.052, 0.06});  // breasts
  shape.y -= 0.55 * bump(at, {0.15, 0.93, -0.03}, {0.08, 0.09, 0.14});      // hips
  shape.y += 0.55 * bump(at, {0.15, 1.09, 0.0}, {0.10, 0.07, 0.16});        // waist
  return glm::clamp(shape, -1.0, 1.0);
}

/// Whether all faces around a point are hair: what stands off the head and may move.
std::vector<bool> is_hair(const Skin& skin) {
  std::vector<bool> hair(skin.points.size(), true);
  for (const SkinFace& face : skin.faces) {
    if (face.region == Region::hair) continue;
    for (const std::size_t corner : face.corners) hair[corner] = false;
  }
  return hair;
}

dvec2 hair_shape(const SkinPoint& point) {
  const dvec3 at = point.position;
  const double front = glm::smoothstep(0.03, 0.09, at.z);
  const double crown = glm::smoothstep(1.60, 1.70, at.y);
  // Below the ears and behind them it hangs down; above it stays.
  const double hanging = (1 - glm::smoothstep(1.60, 1.69, at.y)) * (1 - glm::smoothstep(-0.03, 0.01, at.z));
  return {glm::mix(0.35, 1.0, crown) * (1 - 0.55 * front), hanging};
}

}  // namespace

glm::dvec3 shape_by_joints(const Weights& weights) {
  dvec3 shape(0);
  for (std::size_t joint = 0; joint < joint_count; ++joint) {
    if (weights[joint] > 0) shape += weights[joint] * shape_of(skeleton()[joint].name);
  }
  return shape;
}

std::vector<Shape> shapes_of(const Skin& skin) {
  const std::vector<bool> hair = is_hair(skin);
  std::vector<Shape> shapes;
  for (std::size_t p = 0; p < skin.points.size(); ++p) {
    shapes.push_back({body_shape(skin.points[p]), hair[p] ? hair_shape(skin.points[p]) : dvec2(0)});
  }
  return shapes;
}

}  // namespace throng::mannequin
