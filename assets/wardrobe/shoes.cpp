#include "assets/mannequin/body_parts.h"
#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

/// The shoe of the built-in man: its foot with a ring at the ankle.
mannequin::Skin trainers() {
  const mannequin::Cage cage = shell({Slot::feet}, mannequin::Region::shoes, [](glm::dvec3) { return 0.004; });
  return mirrored_surface(cage);
}

}  // namespace

std::vector<Part> shoes() { return {{"trainers", Slot::shoes, Fits::all, {Slot::feet}, {"casual"}, {}, trainers}}; }

}  // namespace throng::wardrobe
