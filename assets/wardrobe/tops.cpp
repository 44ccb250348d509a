#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Cage;
using mannequin::Region;

/// An example of a part: the man's skin lifted by 8 mm, without what lies below the hem and beyond the sleeve.
mannequin::Skin t_shirt() {
  const auto lift = [](dvec3) { return 0.009; };
  const auto keep = [](dvec3 middle) { return middle.y > 0.93 && middle.x < 0.31; };
  const Cage cage = shell({Slot::torso, Slot::upper_arms, Slot::head}, Region::shirt, lift,
                          [&](dvec3 middle) { return keep(middle) && (middle.y < 1.50); });
  return mirrored_surface(cage);
}

}  // namespace

std::vector<Part> tops() { return {{"t_shirt", Slot::top, Fits::all, {Slot::torso}, {"casual"}, {}, t_shirt}}; }

}  // namespace throng::wardrobe
