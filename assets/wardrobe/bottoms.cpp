#include "assets/wardrobe/clothes.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> bottoms() {
  constexpr Slot bottom = Slot::bottom;
  const std::vector<Slot> legs{Slot::thighs, Slot::shins};
  return {
      {"jeans", bottom, Fits::all, legs, {"casual"}, {}, make_jeans},
      {"chinos", bottom, Fits::all, legs, {"casual", "formal"}, {}, make_chinos},
      {"suit_trousers", bottom, Fits::adults, legs, {"formal"}, {}, make_suit_trousers},
      {"shorts", bottom, Fits::all, {}, {"shorts", "summer", "sport"}, {}, make_shorts},
      {"leggings", bottom, Fits::women_and_children, legs, {"sport"}, {}, make_leggings},
      {"cargo_trousers", bottom, Fits::all, legs, {"work"}, {}, make_cargo_trousers},
      {"track_trousers", bottom, Fits::all, legs, {"sport"}, {}, make_track_trousers},
      {"knee_skirt", bottom, Fits::women_and_children, {Slot::thighs}, {"skirt", "formal"}, {}, make_knee_skirt},
      {"long_skirt", bottom, Fits::women_and_children, {Slot::thighs}, {"long", "summer"}, {}, make_long_skirt},
      {"pleated_skirt", bottom, Fits::women_and_children, {}, {"skirt", "summer"}, {}, make_pleated_skirt},
  };
}

}  // namespace throng::wardrobe
