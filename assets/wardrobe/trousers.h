#pragma once

#include <vector>

#include "assets/wardrobe/tailor.h"

namespace throng::wardrobe {

/// A horizontal cross-section of the left trouser leg, metres.
struct LegRow {
  double height, x, z, half_width, half_depth;
  double trim = 0;        ///< Of the band between this row and the one above.
  double paint = 1;       ///< Of the same band.
  double lift_front = 0;  ///< How much higher it is in front, where the shoe carries it.
};

/// Describes the cut of trousers.
struct TrouserCut {
  Region region = Region::trousers;
  double ease = 0.004;   ///< Around the hips, outside the skin.
  double waist = 1.000;  ///< The height of the upper edge.
  double band_trim = 0;
  std::vector<LegRow> legs = {};  ///< From the thigh to the hem.
  double crease = 0;              ///< How far the pressed crease stands out in front.
  double stripe = 0;              ///< Half the width of a stripe along the side, metres.
  bool turned_in = true;          ///< The hem; a leg that ends in a boot needs none.
};
void add_trousers(Cage& cage, const TrouserCut& cut);

/// The legs of the man himself with so much room in the thigh, at the knee, the calf and the hem.
std::vector<LegRow> leg_rows(double thigh, double knee, double calf, double hem, double hem_height);

}  // namespace throng::wardrobe
