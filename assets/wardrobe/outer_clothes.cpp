#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> outer_clothes() {
  constexpr Slot outer = Slot::outer;
  return {
      {"suit_jacket", outer, Fits::adults, {}, {"formal"}, {}, make_suit_jacket},
      {"waistcoat", outer, Fits::adults, {}, {"formal"}, {}, make_waistcoat},
      {"coat", outer, Fits::all, {}, {"coat", "cold", "formal"}, {}, make_coat},
      {"cardigan", outer, Fits::all, {}, {"cold"}, {}, make_cardigan},
      {"hi_vis", outer, Fits::adults, {}, {"work"}, {}, make_hi_vis},
  };
}

}  // namespace throng::wardrobe
