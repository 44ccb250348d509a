#include "assets/places/props.h"

namespace throng::places {

std::vector<Prop> all_props() {
  std::vector<Prop> all;
  for (const auto& some :
       {arcade_props(), facade_props(), town_house_props(), tower_props(), tree_props(), furniture_props(),
        fountain_props(), kiosk_props(), cloth_props(), stadium_props(), film_props(), horizon_props()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace throng::places
