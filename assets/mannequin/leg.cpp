#include <array>
#include <cmath>
#include <numbers>

#include "assets/mannequin/body_parts.h"

namespace throng::mannequin {
namespace {

/// A horizontal cross-section of the left trouser leg, metres.
struct LegSection {
  double height, x, z, half_width, half_depth;
  Weights weights;
  glm::dvec3 paint = paint::plain;  ///< Of the faces between this section and the one above it.
  bool straight = false;            ///< Of the same faces.
};

LimbRing add_section(Cage& cage, const LegSection& section) {
  LimbRing ring{};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double angle = (static_cast<double>(k) - 1) * std::numbers::pi / 4;
    const double x = section.x + section.half_width * std::sin(angle);
    const double z = section.z + section.half_depth * std::cos(angle);
    ring[k] = cage.add({x, section.height, z}, section.weights);
  }
  return ring;
}

std::array<LegSection, 7> leg_sections() {
  const Weights thigh = bind({{"thigh_twist.L", 0.85}, {"hips", 0.15}});
  const Weights above_knee = bind({{"thigh.L", 0.8}, {"shin.L", 0.2}});
  const Weights below_knee = bind({{"thigh.L", 0.2}, {"shin.L", 0.8}});
  const Weights shin = bind({{"shin.L", 1}});
  const Weights ankle = bind({{"shin.L", 0.5}, {"foot.L", 0.5}});
  return {{{0.790, 0.094, -0.006, 0.087, 0.094, thigh},
           {0.525, 0.098, 0.004, 0.063, 0.068, above_knee},
           {0.462, 0.098, 0.002, 0.060, 0.064, below_knee},
           {0.335, 0.100, -0.014, 0.060, 0.067, shin},
           {0.115, 0.102, -0.018, 0.0515, 0.0605, shin, paint::plain, true},
           {0.078, 0.102, -0.018, 0.051, 0.060, shin, paint::plain, true},
           {0.092, 0.102, -0.018, 0.038, 0.046, ankle, paint::fold, true}}};
}

}  // namespace

LimbRing add_leg(Cage& cage, const LimbRing& leg) {
  LimbRing upper = leg;
  for (const LegSection& section : leg_sections()) {
    const LimbRing ring = add_section(cage, section);
    cage.bridge(ring, upper, true, Region::trousers, section.paint, section.straight);
    upper = ring;
  }
  return upper;
}

}  // namespace throng::mannequin
