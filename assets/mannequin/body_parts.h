#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "assets/mannequin/cage.h"

namespace throng::mannequin {

/// Seven vertices from the front of the centre line around the left side to its back, seen from above.
using HalfRing = std::array<std::size_t, 7>;
/// Eight vertices around a limb, anticlockwise seen from the end that the limb's axis points to.
using LimbRing = std::array<std::size_t, 8>;

/// A horizontal cross-section of the torso, metres.
struct TorsoSection {
  double height, half_width, front, back;
  double drop_front = 0;    ///< How far the front of the ring lies below its sides.
  double drop_back = 0;     ///< The same for the back.
  double squareness = 0.9;  ///< 1 is an ellipse; smaller is more of a box.
};
using RingBinding = std::array<Weights, 7>;
/// Returns the same weights for a whole ring.
RingBinding everywhere(const Weights& weights);
/// Adds the left half of a cross-section, from the front to the back.
HalfRing add_section(Cage& cage, const TorsoSection& section, const RingBinding& binding);

/// The borders of the torso to which the other parts are welded.
struct TorsoBorders {
  HalfRing neck;
  LimbRing armhole;  ///< From below over the back to the top and the front.
  LimbRing leg;      ///< From the inner front over the outer side to the inner back, the crotch last.
};

TorsoBorders add_torso(Cage& cage);
void add_head(Cage& cage, const HalfRing& neck);
/// Returns the ring at the left wrist, turned by half a step so that its flat sides are back and palm.
LimbRing add_arm(Cage& cage, const LimbRing& armhole);
void add_hand(Cage& cage, const LimbRing& wrist);
/// Returns the ring inside the left trouser cuff, from which the shoe goes on.
LimbRing add_leg(Cage& cage, const LimbRing& leg);
void add_shoe(Cage& cage, const LimbRing& cuff);

/// The left half of the body; see mirrored().
Cage build_half_body();

namespace paint {
inline constexpr glm::dvec3 plain{1.0, 1.0, 1.0};
inline constexpr glm::dvec3 fold{0.82, 0.82, 0.84};
}  // namespace paint

}  // namespace throng::mannequin
