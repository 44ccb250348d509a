#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "assets/mannequin/body_parts.h"
#include "assets/wardrobe/make.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::bind;
using mannequin::Cage;
using mannequin::everywhere;
using mannequin::HalfRing;
using mannequin::LimbRing;
using mannequin::Region;
using mannequin::Weights;

void set_piece(Cage& cage, Slot slot) { cage.notes.piece = static_cast<unsigned char>(slot); }

struct Trunk {
  HalfRing crease, hips, belly, waist, ribs, breast, armpit, blade, shoulder;
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
  trunk.crease = mannequin::add_section(cage, {0.905, 0.165, 0.096, -0.124, 0.046, 0.055},
                                        {hips, crease, crease, crease, crease, crease, hips});
  trunk.hips = mannequin::add_section(cage, {0.960, 0.166, 0.100, -0.128, 0.008}, everywhere(hips));
  trunk.belly =
      mannequin::add_section(cage, {1.010, 0.155, 0.098, -0.108}, everywhere(bind({{"hips", 0.8}, {"spine", 0.2}})));
  trunk.waist =
      mannequin::add_section(cage, {1.070, 0.144, 0.096, -0.094}, everywhere(bind({{"hips", 0.4}, {"spine", 0.6}})));
  trunk.ribs = mannequin::add_section(cage, {1.170, 0.148, 0.101, -0.101, 0, 0, 0.88},
                                      everywhere(bind({{"spine", 0.5}, {"chest", 0.5}})));
  trunk.breast = mannequin::add_section(cage, {1.280, 0.160, 0.110, -0.115, 0.006, 0, 0.84},
                                        everywhere(bind({{"chest", 0.5}, {"upper_chest", 0.5}})));
  trunk.armpit = mannequin::add_section(cage, {1.345, 0.164, 0.105, -0.122, 0, 0, 0.82},
                                        {chest, chest, below_pit, pit, below_pit, chest, chest});
  trunk.blade = mannequin::add_section(cage, {1.412, 0.184, 0.084, -0.116, 0, 0, 0.80},
                                       {chest, collar_bone, arm, arm, arm, collar_bone, chest});
  trunk.shoulder = mannequin::add_section(cage, {1.462, 0.172, 0.058, -0.092, 0.022, 0, 0.86},
                                          {chest, collar_bone, edge, cap, edge, collar_bone, chest});
  return trunk;
}

void sculpt(Cage& cage, const Trunk& trunk) {
  const auto nudge = [&](std::size_t vertex, dvec3 offset) { cage.vertices[vertex].position += offset; };
  nudge(trunk.breast[0], {0, 0, -0.006});
  nudge(trunk.breast[1], {0.004, 0, 0.002});
  for (const HalfRing* ring : {&trunk.breast, &trunk.armpit, &trunk.blade}) nudge((*ring)[6], {0, 0, 0.011});
  nudge(trunk.waist[6], {0, 0, 0.008});
  nudge(trunk.crease[5], {0.006, -0.006, -0.004});
  nudge(trunk.crease[6], {0, 0, 0.018});
  nudge(trunk.armpit[3], {-0.004, 0.004, 0});
  nudge(trunk.blade[2], {-0.004, 0, 0});
  for (const std::size_t j : {2U, 4U}) nudge(trunk.shoulder[j], {-0.004, -0.008, 0});
}

void bridge_trunk(Cage& cage, const Trunk& trunk) {
  const std::array<const HalfRing*, 7> rings{&trunk.crease, &trunk.hips,   &trunk.belly, &trunk.waist,
                                             &trunk.ribs,   &trunk.breast, &trunk.armpit};
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) cage.bridge(*rings[r], *rings[r + 1], false, Region::skin);
  const std::array<const HalfRing*, 3> beside_arm{&trunk.armpit, &trunk.blade, &trunk.shoulder};
  for (std::size_t r = 0; r < 2; ++r) {
    const HalfRing& lower = *beside_arm[r];
    const HalfRing& upper = *beside_arm[r + 1];
    for (const std::size_t j : {0U, 1U, 4U, 5U}) {
      cage.add_face({lower[j], lower[j + 1], upper[j + 1], upper[j]}, Region::skin);
    }
  }
}

/// A cross-section of the arm: `half_width` towards the thumb, `half_height` towards the back of the hand.
struct ArmSection {
  double along, half_width, half_height, thumb, back, turn;  ///< `turn` in steps of 45 degrees.
  Weights weights;
  Slot piece;  ///< Of the faces before it.
};

std::array<ArmSection, 11> arm_sections() {
  const Weights deltoid = bind({{"upper_arm_twist.L", 0.85}, {"shoulder.L", 0.15}});
  const Weights upper = bind({{"upper_arm_twist.L", 0.6}, {"upper_arm.L", 0.4}});
  const Weights biceps = bind({{"upper_arm_twist.L", 0.3}, {"upper_arm.L", 0.7}});
  const Weights above = bind({{"upper_arm.L", 0.85}, {"forearm.L", 0.15}});
  const Weights elbow = bind({{"upper_arm.L", 0.5}, {"forearm.L", 0.5}});
  const Weights below = bind({{"upper_arm.L", 0.15}, {"forearm.L", 0.85}});
  const Weights forearm = bind({{"forearm.L", 0.75}, {"forearm_twist.L", 0.25}});
  const Weights lower = bind({{"forearm.L", 0.3}, {"forearm_twist.L", 0.7}});
  const Weights cuff = bind({{"forearm_twist.L", 0.85}, {"hand.L", 0.15}});
  const Weights wrist = bind({{"forearm_twist.L", 0.5}, {"hand.L", 0.5}});
  return {{{0.070, 0.053, 0.052, 0.0, -0.006, 0.0, deltoid, Slot::torso},
           {0.125, 0.048, 0.048, 0.0, -0.002, 0.05, upper, Slot::upper_arms},
           {0.190, 0.044, 0.043, 0.002, 0.0, 0.1, biceps, Slot::upper_arms},
           {0.255, 0.040, 0.039, 0.0, 0.002, 0.2, above, Slot::upper_arms},
           {0.285, 0.039, 0.038, 0.0, 0.003, 0.22, elbow, Slot::upper_arms},
           {0.315, 0.0405, 0.0385, 0.001, 0.002, 0.25, below, Slot::forearms},
           {0.372, 0.041, 0.037, 0.002, 0.0, 0.35, forearm, Slot::forearms},
           {0.430, 0.036, 0.032, 0.0015, 0.0, 0.4, lower, Slot::forearms},
           {0.480, 0.030, 0.0255, 0.001, 0.0, 0.45, lower, Slot::forearms},
           {0.515, 0.0275, 0.022, 0.0, 0.0, 0.5, cuff, Slot::forearms},
           {0.540, 0.0275, 0.0205, 0.0, 0.0, 0.5, wrist, Slot::hands}}};
}

void add_naked_arm(Cage& cage, LimbRing ring) {
  for (const ArmSection& section : arm_sections()) {
    LimbRing next{};
    for (std::size_t k = 0; k < next.size(); ++k) {
      const double angle = (static_cast<double>(k) + section.turn) * std::numbers::pi / 4;
      next[k] = cage.add(mannequin::left_arm().at(section.along, section.thumb - section.half_width * std::sin(angle),
                                                  section.back - section.half_height * std::cos(angle)),
                         section.weights);
    }
    set_piece(cage, section.piece);
    cage.bridge(ring, next, true, Region::skin);
    ring = next;
  }
  set_piece(cage, Slot::hands);
  mannequin::add_hand(cage, ring);
}

/// A horizontal cross-section of the left leg.
struct LegSection {
  double height, x, z, half_width, half_depth;
  Weights weights;
  Slot piece;  ///< Of the faces above it.
};

std::array<LegSection, 9> leg_sections() {
  const Weights thigh = bind({{"thigh_twist.L", 0.85}, {"hips", 0.15}});
  const Weights mid_thigh = bind({{"thigh_twist.L", 0.4}, {"thigh.L", 0.6}});
  const Weights above_knee = bind({{"thigh.L", 0.8}, {"shin.L", 0.2}});
  const Weights knee = bind({{"thigh.L", 0.5}, {"shin.L", 0.5}});
  const Weights below_knee = bind({{"thigh.L", 0.2}, {"shin.L", 0.8}});
  const Weights shin = bind({{"shin.L", 1}});
  const Weights ankle = bind({{"shin.L", 0.6}, {"foot.L", 0.4}});
  return {{{0.790, 0.093, -0.006, 0.081, 0.089, thigh, Slot::thighs},
           {0.660, 0.096, 0.000, 0.068, 0.075, mid_thigh, Slot::thighs},
           {0.535, 0.098, 0.005, 0.056, 0.061, above_knee, Slot::thighs},
           {0.495, 0.098, 0.005, 0.053, 0.058, knee, Slot::thighs},
           {0.450, 0.098, 0.000, 0.051, 0.055, below_knee, Slot::shins},
           {0.345, 0.099, -0.014, 0.052, 0.058, shin, Slot::shins},
           {0.220, 0.101, -0.016, 0.040, 0.046, shin, Slot::shins},
           {0.130, 0.102, -0.018, 0.0330, 0.040, shin, Slot::shins},
           {0.078, 0.102, -0.020, 0.0335, 0.044, ankle, Slot::shins}}};
}

/// A shoe becomes a foot: flat at the toes, the longest of which is the inner one.
void make_bare(mannequin::CageVertex& vertex) {
  dvec3& p = vertex.position;
  const double ahead = glm::smoothstep(0.06, 0.15, p.z);
  p.y *= 1 - 0.42 * ahead;
  p.z += glm::smoothstep(0.13, 0.16, p.z) * (0.010 - 0.25 * (p.x - 0.078));
}

void add_naked_leg(Cage& cage, LimbRing upper) {
  for (const LegSection& section : leg_sections()) {
    LimbRing ring{};
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const double angle = (static_cast<double>(k) - 1) * std::numbers::pi / 4;
      ring[k] = cage.add({section.x + section.half_width * std::sin(angle), section.height,
                          section.z + section.half_depth * std::cos(angle)},
                         section.weights);
    }
    set_piece(cage, section.piece);
    cage.bridge(ring, upper, true, Region::skin);
    upper = ring;
  }
  set_piece(cage, Slot::feet);
  const std::size_t first = cage.faces.size();
  const std::size_t first_vertex = cage.vertices.size();
  mannequin::add_shoe(cage, upper);
  for (std::size_t v = first_vertex; v < cage.vertices.size(); ++v) make_bare(cage.vertices[v]);
  for (std::size_t f = first; f < cage.faces.size(); ++f) {
    cage.faces[f].region = Region::skin;
    cage.faces[f].paint.assign(cage.faces[f].corners.size(), dvec3(1));
  }
}

Cage build() {
  Cage cage;
  set_piece(cage, Slot::torso);
  const Trunk trunk = add_trunk(cage);
  sculpt(cage, trunk);
  bridge_trunk(cage, trunk);
  const Weights yoke = bind({{"upper_chest", 0.65}, {"shoulder.L", 0.25}, {"neck", 0.10}});
  const Weights low_neck = bind({{"upper_chest", 0.65}, {"shoulder.L", 0.1}, {"neck", 0.25}});
  const Weights throat = bind({{"upper_chest", 0.55}, {"neck", 0.45}});
  const HalfRing slope =
      mannequin::add_section(cage, {1.485, 0.112, 0.043, -0.092, 0.022, -0.004, 0.95}, everywhere(yoke));
  cage.bridge(trunk.shoulder, slope, false, Region::skin);
  const HalfRing neck =
      mannequin::add_section(cage, {1.516, 0.0585, 0.036, -0.0775, 0.030, -0.008, 1.0}, everywhere(throat));
  const HalfRing nape =
      mannequin::add_section(cage, {1.499, 0.0770, 0.0405, -0.0835, 0.026, -0.006, 0.98}, everywhere(low_neck));
  set_piece(cage, Slot::head);
  cage.bridge(slope, nape, false, Region::skin);
  cage.bridge(nape, neck, false, Region::skin);

  const HalfRing& low = trunk.armpit;
  const HalfRing& mid = trunk.blade;
  const HalfRing& top = trunk.shoulder;
  add_naked_arm(cage, {low[3], low[4], mid[4], top[4], top[3], top[2], mid[2], low[2]});
  const std::size_t crotch = cage.add({0, 0.832, 0.006}, bind({{"hips", 0.6}, {"thigh.L", 0.4}}));
  const HalfRing& leg = trunk.crease;
  add_naked_leg(cage, {leg[0], leg[1], leg[2], leg[3], leg[4], leg[5], leg[6], crotch});
  return cage;
}

}  // namespace

const Cage& man_cage() {
  static const Cage cage = build();
  return cage;
}

}  // namespace throng::wardrobe
