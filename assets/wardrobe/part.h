#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

enum class Body : unsigned char { man, woman, child };
inline constexpr std::array all_bodies{Body::man, Body::woman, Body::child};
std::string_view name_of(Body body);

/// Names the bodies that a part is made for, as bits.
enum class Fits : unsigned char {
  man = 1,
  woman = 2,
  adults = 3,
  child = 4,
  men_and_children = 5,
  women_and_children = 6,
  all = 7
};
bool fits(Fits fits, Body body);

/// Names the place where a part is worn. The first eight are the pieces of skin that each body has.
enum class Slot : unsigned char {
  head,
  torso,
  upper_arms,
  forearms,
  hands,
  thighs,
  shins,
  feet,
  top,
  bottom,
  outer,
  shoes,
  hair,
  headgear,
  face,
  back,
  hand_left,
  hand_right,
  silhouette
};
inline constexpr std::size_t piece_count = 8;
std::string_view name_of(Slot slot);

/// Something that a body wears.
/// `make` returns its surface where the naked man rests, with weights, regions, paint and notes; openness, normals and
/// coordinates of patterns come later. The framework warps it to the other bodies.
struct Part {
  std::string name;
  Slot slot;
  Fits bodies = Fits::all;
  std::vector<Slot> covers = {};  ///< Pieces of skin, and slots, that are not drawn beneath it.
  std::vector<std::string> tags = {};
  std::vector<Slot> keeps_out = {};  ///< Slots that cannot be worn with it.
  std::function<mannequin::Skin()> make;
};

/// All parts, those of the bodies aside, in the order of the file.
const std::vector<Part>& all_parts();
/// Returns the part of that name that fits a body; null without one.
const Part* find_part(std::string_view name, Body body);

// One list a file of parts; catalogue.cpp joins them.
std::vector<Part> short_hair();
std::vector<Part> long_hair();
std::vector<Part> headgear();
std::vector<Part> faces();
std::vector<Part> tops();
std::vector<Part> bottoms();
std::vector<Part> outer_clothes();
std::vector<Part> shoes();
std::vector<Part> bags();
std::vector<Part> hand_things();

}  // namespace throng::wardrobe
