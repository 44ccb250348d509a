#include "assets/wardrobe/pattern.h"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::Chart;
using mannequin::joint_count;
using mannequin::SkinFace;

constexpr double pattern_step = 1.0 / 1024;
constexpr double trunk_radius = 0.16, leg_radius = 0.085, arm_radius = 0.055;

enum class Axis { trunk, left_arm, right_arm, left_leg, right_leg };

Axis axis_of(const mannequin::Skin& skin, const SkinFace& face) {
  if (face.notes.chart == Chart::around_body) return Axis::trunk;
  double arm = 0, leg = 0, x = 0;
  for (const std::size_t corner : face.corners) {
    for (std::size_t j = 0; j < joint_count; ++j) {
      const std::string& name = mannequin::skeleton()[j].name;
      const double weight = skin.points[corner].weights[j];
      if (name.starts_with("upper_arm") || name.starts_with("forearm") || name.starts_with("hand")) arm += weight;
      if (name.starts_with("thigh") || name.starts_with("shin") || name.starts_with("foot")) leg += weight;
    }
    x += skin.points[corner].position.x;
  }
  const double half = 0.5 * static_cast<double>(face.corners.size());
  if (arm > half) return x > 0 ? Axis::left_arm : Axis::right_arm;
  if (leg > half) return x > 0 ? Axis::left_leg : Axis::right_leg;
  return Axis::trunk;
}

/// The angle around an axis and the place along it.
dvec2 around(Axis axis, dvec3 p) {
  const double side = axis == Axis::right_arm || axis == Axis::right_leg ? -1 : 1;
  if (axis == Axis::trunk) return {std::atan2(p.x, p.z + 0.010), p.y};
  if (axis == Axis::left_leg || axis == Axis::right_leg) return {std::atan2(p.x - 0.098 * side, p.z + 0.005), p.y};
  const mannequin::ArmFrame& frame = mannequin::left_arm();
  const dvec3 from = dvec3(p.x * side, p.y, p.z) - frame.shoulder;
  return {side * std::atan2(glm::dot(from, frame.backwards), glm::dot(from, frame.thumbwards)),
          glm::dot(from, frame.along)};
}

double radius_of(Axis axis) {
  if (axis == Axis::trunk) return trunk_radius;
  return axis == Axis::left_leg || axis == Axis::right_leg ? leg_radius : arm_radius;
}

dvec2 rounded_pattern(dvec2 place) { return glm::round(place / pattern_step) * pattern_step + dvec2(0); }

}  // namespace

void lay_patterns(mannequin::Skin& skin) {
  for (SkinFace& face : skin.faces) {
    if (!face.pattern.empty()) continue;
    dvec3 middle(0);
    for (const std::size_t corner : face.corners) middle += skin.points[corner].position;
    middle /= static_cast<double>(face.corners.size());
    const Axis axis = axis_of(skin, face);
    const double centre = around(axis, middle).x;
    for (const std::size_t corner : face.corners) {
      const dvec3 p = skin.points[corner].position;
      if (face.notes.chart == Chart::from_front || face.notes.chart == Chart::from_side) {
        face.pattern.push_back(rounded_pattern({face.notes.chart == Chart::from_front ? p.x : p.z, p.y}));
        continue;
      }
      dvec2 place = around(axis, p);
      constexpr double turn = 2 * std::numbers::pi;
      place.x -= turn * std::round((place.x - centre) / turn);
      face.pattern.push_back(rounded_pattern({place.x * radius_of(axis), place.y}));
    }
  }
}

}  // namespace throng::wardrobe
