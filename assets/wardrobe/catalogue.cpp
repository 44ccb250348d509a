#include <algorithm>
#include <array>
#include <iterator>

#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

std::vector<Part> collect() {
  std::vector<Part> parts;
  for (const auto list :
       {short_hair, long_hair, headgear, faces, tops, bottoms, outer_clothes, shoes, bags, hand_things}) {
    std::vector<Part> some = list();
    std::move(some.begin(), some.end(), std::back_inserter(parts));
  }
  return parts;
}

}  // namespace

std::string_view name_of(Body body) {
  constexpr std::array<std::string_view, 3> names{"man", "woman", "child"};
  return names[static_cast<std::size_t>(body)];
}

bool fits(Fits fits, Body body) { return (static_cast<unsigned>(fits) >> static_cast<unsigned>(body) & 1U) != 0; }

std::string_view name_of(Slot slot) {
  constexpr std::array<std::string_view, 19> names{
      "head",  "torso", "upper_arms", "forearms", "hands", "thighs", "shins",     "feet",       "top",       "bottom",
      "outer", "shoes", "hair",       "headgear", "face",  "back",   "hand_left", "hand_right", "silhouette"};
  return names[static_cast<std::size_t>(slot)];
}

const std::vector<Part>& all_parts() {
  static const std::vector<Part> parts = collect();
  return parts;
}

const Part* find_part(std::string_view name, Body body) {
  const auto found = std::find_if(all_parts().begin(), all_parts().end(),
                                  [&](const Part& p) { return p.name == name && fits(p.bodies, body); });
  return found == all_parts().end() ? nullptr : &*found;
}

}  // namespace throng::wardrobe
