#include <array>
#include <cmath>
#include <numbers>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

/// A cross-section of the arm: distances in metres along it and of its centre from the bone.
struct ArmSection {
  double along;
  double half_width, half_height;  ///< Across the thumb's direction, and from the palm's to the back's side.
  double thumb, back;              ///< Offset of the centre.
  double turn;                     ///< Of the ring about the bone, in steps of 45 degrees.
  Weights weights;
  Region region;  ///< Of the faces between this section and the one before it.
  glm::dvec3 paint = paint::plain;
  bool straight = false;  ///< Of the same faces.
};

LimbRing add_section(Cage& cage, const ArmSection& section) {
  LimbRing ring{};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double angle = (static_cast<double>(k) + section.turn) * std::numbers::pi / 4;
    const double thumb = section.thumb - section.half_width * std::sin(angle);
    const double back = section.back - section.half_height * std::cos(angle);
    ring[k] = cage.add(left_arm().at(section.along, thumb, back), section.weights);
  }
  return ring;
}

std::array<ArmSection, 8> arm_sections() {
  const Weights deltoid = bind({{"upper_arm_twist.L", 0.85}, {"shoulder.L", 0.15}});
  const Weights sleeve = bind({{"upper_arm_twist.L", 0.5}, {"upper_arm.L", 0.5}});
  const Weights above_elbow = bind({{"upper_arm.L", 0.8}, {"forearm.L", 0.2}});
  const Weights below_elbow = bind({{"upper_arm.L", 0.2}, {"forearm.L", 0.8}});
  const Weights forearm = bind({{"forearm.L", 0.75}, {"forearm_twist.L", 0.25}});
  const Weights lower_forearm = bind({{"forearm.L", 0.3}, {"forearm_twist.L", 0.7}});
  const Weights wrist = bind({{"forearm_twist.L", 0.5}, {"hand.L", 0.5}});
  return {{{0.070, 0.060, 0.058, 0.0, -0.006, 0.0, deltoid, Region::shirt},
           {0.172, 0.054, 0.054, 0.0, 0.0, 0.1, sleeve, Region::shirt},
           {0.164, 0.043, 0.043, 0.002, 0.0, 0.1, sleeve, Region::shirt, paint::fold, true},
           {0.262, 0.040, 0.039, 0.0, 0.002, 0.2, above_elbow, Region::skin},
           {0.308, 0.041, 0.039, 0.0, 0.002, 0.25, below_elbow, Region::skin},
           {0.372, 0.042, 0.038, 0.002, 0.0, 0.35, forearm, Region::skin},
           {0.470, 0.031, 0.027, 0.001, 0.0, 0.45, lower_forearm, Region::skin, paint::plain, true},
           {0.538, 0.0275, 0.0205, 0.0, 0.0, 0.5, wrist, Region::skin}}};
}

}  // namespace

LimbRing add_arm(Cage& cage, const LimbRing& armhole) {
  LimbRing previous = armhole;
  for (const ArmSection& section : arm_sections()) {
    const LimbRing ring = add_section(cage, section);
    cage.bridge(previous, ring, true, section.region, section.paint, section.straight);
    previous = ring;
  }
  return previous;
}

}  // namespace throng::mannequin
