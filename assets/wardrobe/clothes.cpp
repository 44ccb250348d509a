#include "assets/wardrobe/clothes.h"

#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

std::vector<Part> tops() {
  constexpr Slot top = Slot::top;
  const std::vector<Slot> trunk{Slot::torso};
  const std::vector<Slot> trunk_and_arms{Slot::torso, Slot::upper_arms, Slot::forearms};
  return {
      {"t_shirt", top, Fits::all, trunk, {"summer"}, {}, make_t_shirt},
      {"polo", top, Fits::all, trunk, {"summer", "sport"}, {}, make_polo},
      {"tank_top", top, Fits::all, trunk, {"summer", "sport"}, {}, make_tank_top},
      {"shirt", top, Fits::all, trunk_and_arms, {"formal"}, {}, make_shirt},
      {"blouse", top, Fits::women_and_children, trunk_and_arms, {"formal"}, {}, make_blouse},
      {"jumper", top, Fits::all, trunk_and_arms, {"cold"}, {}, make_jumper},
      {"hoodie", top, Fits::all, trunk_and_arms, {"cold", "sport"}, {Slot::outer}, make_hoodie},
      {"puffer", top, Fits::all, trunk_and_arms, {"cold"}, {Slot::outer}, make_puffer},
      {"rain_jacket", top, Fits::all, trunk_and_arms, {"rain"}, {Slot::outer}, make_rain_jacket},
      {"summer_dress",
       top,
       Fits::women_and_children,
       {Slot::torso, Slot::bottom},
       {"skirt", "summer"},
       {Slot::bottom},
       make_summer_dress},
      {"evening_dress",
       top,
       Fits::woman,
       {Slot::torso, Slot::thighs, Slot::shins, Slot::bottom},
       {"long", "formal"},
       {Slot::bottom},
       make_evening_dress},
  };
}

std::vector<Part> outer_clothes() {
  constexpr Slot outer = Slot::outer;
  return {
      {"suit_jacket", outer, Fits::adults, {}, {"formal", "sleeved"}, {}, make_suit_jacket},
      {"waistcoat", outer, Fits::adults, {}, {"formal", "sleeveless"}, {}, make_waistcoat},
      {"coat", outer, Fits::all, {}, {"coat", "cold", "formal", "sleeved"}, {}, make_coat},
      {"cardigan", outer, Fits::all, {}, {"cold", "sleeved"}, {}, make_cardigan},
      {"hi_vis", outer, Fits::adults, {}, {"work", "sleeveless"}, {}, make_hi_vis},
  };
}

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
