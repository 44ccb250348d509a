#pragma once

#include <array>
#include <vector>

#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {

/// The edge of a shoe's opening, or a row of its shaft: an upright ring around the ankle.
struct ShaftRow {
  double height, half_width, half_depth;
  double z = -0.020;
  double rise_front = 0;  ///< How much higher it is in front than behind.
  double trim = 0;        ///< Of the band between this row and the one below.
  double paint = 1;       ///< Of the same band.
};

/// Describes the cut of a closed shoe.
struct ShoeCut {
  double sole = 0.016;      ///< Its height.
  double sole_grow = 1.05;  ///< Its outline against the foot's.
  double upper_grow = 1.02;
  double pointed = 0;     ///< Moves the tip ahead and its sides in, metres.
  double heel = 0;        ///< The height of a heel of its own; the arch rises to it.
  double heel_block = 0;  ///< Half its width, metres.
  double ball_height = 0.068, toe_height = 0.053;
  double sole_trim = 1, sole_paint = 1;
  double toe_trim = 0;               ///< Of the toe cap.
  std::vector<ShaftRow> shaft = {};  ///< From the instep up; the first closes the shoe.
};
void add_shoe(Cage& cage, const ShoeCut& cut);

using Outline = std::array<std::size_t, 12>;
/// The foot's outline at a height: toe from the inner to the outer side, outer side, heel, inner side.
Outline add_outline(Cage& cage, const ShoeCut& cut, double height, double grow, double toe_spring);
/// The sole seen from below.
void close_sole(Cage& cage, const Outline& outline, double trim, double paint);

}  // namespace throng::wardrobe
