#pragma once

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

// Makers of garments, on the man. clothes.cpp and shoes.cpp list them.

mannequin::Skin make_t_shirt();
mannequin::Skin make_polo();
mannequin::Skin make_tank_top();
mannequin::Skin make_shirt();
mannequin::Skin make_blouse();
mannequin::Skin make_jumper();
mannequin::Skin make_hoodie();
mannequin::Skin make_puffer();
mannequin::Skin make_rain_jacket();
mannequin::Skin make_summer_dress();
mannequin::Skin make_evening_dress();

mannequin::Skin make_suit_jacket();
mannequin::Skin make_waistcoat();
mannequin::Skin make_coat();
mannequin::Skin make_cardigan();
mannequin::Skin make_hi_vis();

mannequin::Skin make_jeans();
mannequin::Skin make_chinos();
mannequin::Skin make_suit_trousers();
mannequin::Skin make_shorts();
mannequin::Skin make_leggings();
mannequin::Skin make_cargo_trousers();
mannequin::Skin make_track_trousers();
mannequin::Skin make_knee_skirt();
mannequin::Skin make_long_skirt();
mannequin::Skin make_pleated_skirt();

mannequin::Skin make_trainers();
mannequin::Skin make_leather_shoes();
mannequin::Skin make_boots();
mannequin::Skin make_heeled_boots();
mannequin::Skin make_ballet_flats();
mannequin::Skin make_sandals();
mannequin::Skin make_wellingtons();

}  // namespace throng::wardrobe
