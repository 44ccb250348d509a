#include <algorithm>
#include <cmath>
#include <numbers>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

void nudge(Cage& cage, std::size_t vertex, dvec3 offset) { cage.vertices[vertex].position += offset; }

struct Trunk {
  HalfRing crease, waistband, hem, waist, ribs, breast, armpit, shoulder_blade, shoulder;
};

Trunk add_trunk(Cage& cage) {
  const Weights hips = bind({{"hips", 1}});
  const Weights crease = bind({{"hips", 0.5}, {"thigh.L", 0.3}, {"thigh_twist.L", 0.2}});
  const Weights chest = bind({{"upper_chest", 1}});
  const Weights arm = bind({{"upper_chest", 0.5}, {"shoulder.L", 0.25}, {"upper_arm_twist.L", 0.25}});
  const Weights cap = bind({{"shoulder.L", 0.55}, {"upper_arm_twist.L", 0.45}});
  const Weights edge = bind({{"upper_chest", 0.25}, {"shoulder.L", 0.5}, {"upper_arm_twist.L", 0.25}});
  const Weights collar_bone = bind({{"upper_chest", 0.7}, {"shoulder.L", 0.3}});
  const Weights pit = bind({{"upper_chest", 0.65}, {"upper_arm_twist.L", 0.35}});
  const Weights below_pit = bind({{"upper_chest", 0.8}, {"shoulder.L", 0.1}, {"upper_arm_twist.L", 0.1}});
  Trunk trunk{};
  trunk.crease = add_section(cage, {0.905, 0.170, 0.100, -0.128, 0.046, 0.055, 0.9},
                             {hips, crease, crease, crease, crease, crease, hips});
  trunk.waistband = add_section(cage, {0.972, 0.161, 0.098, -0.118, 0.006, 0.0, 0.88}, everywhere(hips));
  trunk.hem = add_section(cage, {0.956, 0.174, 0.111, -0.141, 0.008, 0.0, 0.90}, everywhere(hips));
  trunk.waist = add_section(cage, {1.065, 0.150, 0.103, -0.102, 0.0, 0.0, 0.9},
                            everywhere(bind({{"hips", 0.45}, {"spine", 0.55}})));
  trunk.ribs = add_section(cage, {1.170, 0.153, 0.108, -0.108, 0.0, 0.0, 0.88},
                           everywhere(bind({{"spine", 0.5}, {"chest", 0.5}})));
  trunk.breast = add_section(cage, {1.280, 0.166, 0.117, -0.122, 0.006, 0.0, 0.84},
                             everywhere(bind({{"chest", 0.5}, {"upper_chest", 0.5}})));
  trunk.armpit = add_section(cage, {1.345, 0.170, 0.112, -0.128, 0.0, 0.0, 0.82},
                             {chest, chest, below_pit, pit, below_pit, chest, chest});
  trunk.shoulder_blade = add_section(cage, {1.412, 0.190, 0.090, -0.122, 0.0, 0.0, 0.80},
                                     {chest, collar_bone, arm, arm, arm, collar_bone, chest});
  trunk.shoulder = add_section(cage, {1.468, 0.178, 0.064, -0.098, 0.022, 0.0, 0.86},
                               {chest, collar_bone, edge, cap, edge, collar_bone, chest});
  return trunk;
}

void sculpt(Cage& cage, const Trunk& trunk) {
  for (const std::size_t j : {0U, 6U}) nudge(cage, trunk.breast[j], {0, 0, j == 0 ? -0.006 : 0.010});
  nudge(cage, trunk.breast[1], {0.004, 0, 0.002});
  nudge(cage, trunk.armpit[6], {0, 0, 0.012});
  nudge(cage, trunk.shoulder_blade[6], {0, 0, 0.012});
  nudge(cage, trunk.waist[6], {0, 0, 0.008});
  nudge(cage, trunk.crease[5], {0.006, -0.006, -0.004});
  nudge(cage, trunk.crease[6], {0, 0, 0.018});
  nudge(cage, trunk.armpit[3], {-0.004, 0.004, 0});
  nudge(cage, trunk.shoulder_blade[2], {-0.004, 0, 0});
  nudge(cage, trunk.shoulder[2], {-0.004, -0.008, 0});
  nudge(cage, trunk.shoulder[4], {-0.004, -0.008, 0});
}

/// The shirt between armpit and shoulder, but for the four faces where the arm goes on.
void bridge_around_armhole(Cage& cage, const HalfRing& lower, const HalfRing& upper) {
  for (const std::size_t j : {0U, 1U, 4U, 5U}) {
    cage.add_face({lower[j], lower[j + 1], upper[j + 1], upper[j]}, Region::shirt);
  }
}

}  // namespace

RingBinding everywhere(const Weights& weights) {
  RingBinding all;
  all.fill(weights);
  return all;
}

HalfRing add_section(Cage& cage, const TorsoSection& section, const RingBinding& binding) {
  HalfRing ring{};
  const double middle = 0.5 * (section.front + section.back);
  const double depth = 0.5 * (section.front - section.back);
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const double angle = static_cast<double>(j) * std::numbers::pi / 6;
    const double side = j == 0 || j == 6 ? 0 : std::pow(std::sin(angle), section.squareness);
    const double fore =
        j == 3 ? 0 : std::copysign(std::pow(std::abs(std::cos(angle)), section.squareness), std::cos(angle));
    const double drop = fore > 0 ? section.drop_front * fore : section.drop_back * -fore;
    ring[j] = cage.add({section.half_width * side, section.height - drop, middle + depth * fore}, binding[j]);
  }
  return ring;
}

TorsoBorders add_torso(Cage& cage) {
  const Trunk trunk = add_trunk(cage);
  sculpt(cage, trunk);
  const Weights yoke = bind({{"upper_chest", 0.65}, {"shoulder.L", 0.25}, {"neck", 0.10}});
  const Weights throat = bind({{"upper_chest", 0.55}, {"neck", 0.45}});
  const HalfRing slope = add_section(cage, {1.494, 0.112, 0.048, -0.092, 0.022, -0.004, 0.95}, everywhere(yoke));
  const HalfRing collar = add_section(cage, {1.514, 0.071, 0.046, -0.083, 0.030, 0.0, 1.0}, everywhere(throat));
  const HalfRing skin = add_section(cage, {1.510, 0.059, 0.036, -0.074, 0.030, 0.0, 1.0}, everywhere(throat));
  cage.bridge(trunk.crease, trunk.waistband, false, Region::trousers);
  cage.bridge(trunk.waistband, trunk.hem, false, Region::shirt, paint::fold, true);
  cage.bridge(trunk.hem, trunk.waist, false, Region::shirt);
  cage.bridge(trunk.waist, trunk.ribs, false, Region::shirt);
  cage.bridge(trunk.ribs, trunk.breast, false, Region::shirt);
  cage.bridge(trunk.breast, trunk.armpit, false, Region::shirt);
  bridge_around_armhole(cage, trunk.armpit, trunk.shoulder_blade);
  bridge_around_armhole(cage, trunk.shoulder_blade, trunk.shoulder);
  cage.bridge(trunk.shoulder, slope, false, Region::shirt);
  cage.bridge(slope, collar, false, Region::shirt);
  cage.bridge(collar, skin, false, Region::shirt, paint::fold, true);

  const HalfRing& low = trunk.armpit;
  const HalfRing& mid = trunk.shoulder_blade;
  const HalfRing& top = trunk.shoulder;
  const std::size_t crotch = cage.add({0, 0.832, 0.006}, bind({{"hips", 0.6}, {"thigh.L", 0.4}}));
  const HalfRing& leg = trunk.crease;
  return {skin,
          {low[3], low[4], mid[4], top[4], top[3], top[2], mid[2], low[2]},
          {leg[0], leg[1], leg[2], leg[3], leg[4], leg[5], leg[6], crotch}};
}

}  // namespace throng::mannequin
