#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

mannequin::Skin jeans() {
  return mirrored_surface(shell(
      {Slot::torso, Slot::thighs, Slot::shins}, mannequin::Region::trousers,
      [](glm::dvec3 place) { return place.y > 0.95 ? 0.004 : 0.007; },
      [](glm::dvec3 middle) { return middle.y < 1.03; }));
}

}  // namespace

std::vector<Part> bottoms() {
  return {{"jeans", Slot::bottom, Fits::all, {Slot::thighs, Slot::shins}, {"casual"}, {}, jeans}};
}

}  // namespace throng::wardrobe
