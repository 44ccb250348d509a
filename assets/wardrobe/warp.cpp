#include "assets/wardrobe/warp.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/curve.h"
#include "assets/wardrobe/head_warp.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::CurveKey;
using mannequin::open_curve;
using mannequin::Weights;

/// A limb that is warped in a way of its own.
enum class Limb : unsigned char { trunk, neck, head, arm_left, arm_right, leg_left, leg_right };
constexpr std::size_t limb_count = 7;

Limb limb_of(std::string_view joint) {
  const bool left = joint.ends_with(".L");
  if (joint == "neck") return Limb::neck;
  if (joint == "head" || joint == "jaw" || joint.starts_with("eye")) return Limb::head;
  for (const std::string_view leg : {"thigh", "shin", "foot", "toe"}) {
    if (joint.starts_with(leg)) return left ? Limb::leg_left : Limb::leg_right;
  }
  if (!joint.ends_with(".L") && !joint.ends_with(".R")) return Limb::trunk;
  if (joint.starts_with("shoulder")) return Limb::trunk;
  return left ? Limb::arm_left : Limb::arm_right;
}

const std::array<Limb, mannequin::joint_count>& limbs() {
  static const auto all = [] {
    std::array<Limb, mannequin::joint_count> limbs{};
    for (std::size_t j = 0; j < limbs.size(); ++j) limbs[j] = limb_of(mannequin::skeleton()[j].name);
    return limbs;
  }();
  return all;
}

/// Lists how a body's limbs differ from the man's: factors by height, or by metres along the arm.
struct Build {
  std::span<const CurveKey> width, front, back;  ///< Of the trunk.
  std::span<const CurveKey> arm, leg;            ///< Of the girth.
  double shoulder;                               ///< Metres that an arm lies further in.
  double leg_in;                                 ///< Metres that a knee lies further in.
  double hand;                                   ///< Width of the hand.
  double foot_width, foot_length;
  double neck;
};

constexpr std::array<CurveKey, 12> woman_width{{{0.83, 1.06},
                                                {0.905, 1.085},
                                                {0.960, 1.08},
                                                {1.010, 1.02},
                                                {1.075, 0.85},
                                                {1.170, 0.84},
                                                {1.280, 0.87},
                                                {1.345, 0.89},
                                                {1.412, 0.90},
                                                {1.462, 0.885},
                                                {1.490, 0.86},
                                                {1.52, 0.84}}};
constexpr std::array<CurveKey, 7> woman_front{
    {{0.83, 0.98}, {0.93, 0.98}, {1.02, 0.95}, {1.08, 0.87}, {1.17, 0.87}, {1.28, 0.90}, {1.42, 0.84}}};
constexpr std::array<CurveKey, 7> woman_back{
    {{0.83, 1.05}, {0.915, 1.12}, {1.00, 1.02}, {1.08, 0.86}, {1.17, 0.86}, {1.28, 0.88}, {1.42, 0.86}}};
constexpr std::array<CurveKey, 6> woman_arm{
    {{0.0, 0.88}, {0.07, 0.84}, {0.19, 0.80}, {0.285, 0.83}, {0.372, 0.82}, {0.52, 0.86}}};
constexpr std::array<CurveKey, 7> woman_leg{
    {{0.09, 0.87}, {0.22, 0.90}, {0.345, 0.93}, {0.495, 0.92}, {0.66, 1.0}, {0.79, 1.06}, {0.90, 1.06}}};

constexpr std::array<CurveKey, 8> child_width{
    {{0.83, 0.98}, {0.93, 0.98}, {1.02, 1.02}, {1.10, 1.06}, {1.20, 1.00}, {1.345, 0.94}, {1.462, 0.90}, {1.50, 0.92}}};
constexpr std::array<CurveKey, 6> child_front{
    {{0.83, 1.0}, {0.93, 1.08}, {1.04, 1.30}, {1.14, 1.20}, {1.28, 1.0}, {1.45, 0.96}}};
constexpr std::array<CurveKey, 4> child_back{{{0.83, 0.98}, {0.92, 1.0}, {1.08, 1.04}, {1.35, 0.94}}};
constexpr std::array<CurveKey, 6> child_arm{
    {{0.0, 0.92}, {0.07, 0.90}, {0.19, 0.94}, {0.285, 1.0}, {0.372, 1.0}, {0.52, 1.12}}};
constexpr std::array<CurveKey, 6> child_leg{
    {{0.09, 1.14}, {0.22, 1.10}, {0.345, 1.02}, {0.495, 1.06}, {0.66, 1.03}, {0.85, 1.0}}};

constexpr Build woman_build{woman_width, woman_front, woman_back, woman_arm, woman_leg, 0.014,
                            0.008,       0.88,        0.88,       0.90,      0.84};
constexpr Build child_build{child_width, child_front, child_back, child_arm, child_leg, 0.016,
                            0.0,         1.04,        1.02,       0.96,      0.86};

/// A soft bump around a place, the same on both sides; 1 in its middle.
double bump(dvec3 place, dvec3 centre, dvec3 radius) {
  const dvec3 offset = (dvec3(std::abs(place.x), place.y, place.z) - centre) / radius;
  return std::exp(-glm::dot(offset, offset));
}

dvec3 trunk(const Build& build, dvec3 p) {
  constexpr double middle = -0.010;
  const double depth = open_curve(p.z > middle ? build.front : build.back, p.y);
  const double other = open_curve(p.z > middle ? build.back : build.front, p.y);
  // Front and back have factors of their own; they meet at the sides.
  const double side = glm::smoothstep(0.0, 0.05, std::abs(p.z - middle));
  const double factor = glm::mix(0.5 * (depth + other), depth, side);
  return {p.x * open_curve(build.width, p.y), p.y, middle + (p.z - middle) * factor};
}

dvec3 breasts(dvec3 p) {
  const double upper = bump(p, {0.070, 1.262, 0.105}, {0.060, p.y > 1.262 ? 0.075 : 0.048, 0.10});
  return {std::copysign(0.006 * upper, p.x) * std::min(std::abs(p.x) / 0.03, 1.0), -0.004 * upper, 0.046 * upper};
}

dvec3 arm(const Build& build, dvec3 p, double side) {
  const mannequin::ArmFrame& frame = mannequin::left_arm();
  const dvec3 left(p.x * side, p.y, p.z);
  const dvec3 from = left - frame.shoulder;
  const double along = glm::dot(from, frame.along);
  const double hand = glm::smoothstep(0.51, 0.58, along);
  const double girth = glm::mix(open_curve(build.arm, along), build.hand, hand);
  const dvec3 axis = frame.at(along);
  const dvec3 there = axis + (left - axis) * girth - dvec3(build.shoulder, 0, 0);
  return {there.x * side, there.y, there.z};
}

dvec3 leg(const Build& build, dvec3 p, double side) {
  const dvec3 left(p.x * side, p.y, p.z);
  const double knee_z = 0.004 - 0.020 * glm::smoothstep(0.45, 0.10, p.y);
  const dvec3 axis(glm::mix(0.102, 0.092, glm::smoothstep(0.10, 0.90, p.y)), p.y, knee_z);
  const double girth = open_curve(build.leg, p.y);
  const double inwards = build.leg_in * (1 - glm::smoothstep(0.60, 0.90, p.y));
  const dvec3 limb = axis + (left - axis) * dvec3(girth, 1, girth) - dvec3(inwards, 0, 0);
  const dvec3 heel(0.104, 0, -0.022);
  const dvec3 foot = heel + (left - heel) * dvec3(build.foot_width, 1, build.foot_length) - dvec3(inwards, 0, 0);
  const dvec3 there = glm::mix(foot, limb, glm::smoothstep(0.05, 0.12, p.y));
  return {there.x * side, there.y, there.z};
}

dvec3 neck(const Build& build, dvec3 p) {
  const dvec3 axis(0, p.y, glm::mix(-0.020, -0.026, glm::smoothstep(1.5, 1.57, p.y)));
  const double girth = glm::mix(open_curve(build.width, p.y), build.neck, glm::smoothstep(1.49, 1.53, p.y));
  return axis + (p - axis) * dvec3(girth, 1, girth);
}

dvec3 limb_warped(Body body, const Build& build, Limb limb, dvec3 p) {
  switch (limb) {
    case Limb::trunk:
      return trunk(build, p) + (body == Body::woman ? breasts(p) : dvec3(0));
    case Limb::neck:
      return neck(build, p);
    case Limb::head:
      return head_warped(body, p);
    case Limb::arm_left:
      return arm(build, p, 1);
    case Limb::arm_right:
      return arm(build, p, -1);
    case Limb::leg_left:
      return leg(build, p, 1);
    case Limb::leg_right:
      return leg(build, p, -1);
  }
  return p;
}

}  // namespace

dvec3 warped(Body body, dvec3 place, const Weights& weights) {
  const bool is_on_the_ground = weights[mannequin::joint_index("root")] > 0.5;
  if (body == Body::man || is_on_the_ground) return place;
  const Build& build = body == Body::woman ? woman_build : child_build;
  std::array<double, limb_count> shares{};
  double sum = 0;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    shares[static_cast<std::size_t>(limbs()[j])] += weights[j];
    sum += weights[j];
  }
  dvec3 there(0);
  for (std::size_t limb = 0; limb < limb_count; ++limb) {
    if (shares[limb] > 0) there += shares[limb] / sum * limb_warped(body, build, static_cast<Limb>(limb), place);
  }
  return there;
}

Weights warped_weights(Body body, const Weights& weights) {
  if (body != Body::child) return weights;
  Weights moved = weights;
  for (const std::string_view eye : {"eye.L", "eye.R"}) {
    moved[mannequin::joint_index("head")] += moved[mannequin::joint_index(eye)];
    moved[mannequin::joint_index(eye)] = 0;
  }
  return moved;
}

double drawn_scale(Body body) { return body == Body::man ? 1.0 : body == Body::woman ? 0.93 : 0.66; }

}  // namespace throng::wardrobe
