#pragma once

#include <functional>
#include <vector>

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

/// A point of a lock from its lower end up: where it is, and how its colour differs.
struct HairPoint {
  glm::dvec3 place;
  glm::dvec3 paint{1};
};

/// Describes a surface around the head: columns of equal numbers of points, by angle (head_surface.h).
struct HairPlan {
  double from = -180, to = 180;  ///< All around: the first column follows the last.
  std::size_t columns = 28;
  mannequin::Region region = mannequin::Region::hair;
  bool closed_top = true;  ///< All columns end in the crown's one point.
  std::function<std::vector<HairPoint>(double angle)> column;
};
mannequin::Skin hair_surface(const HairPlan& plan);

/// A row of the head where short hair ends: over the forehead, around the ears, in the nape.
double hairline(double angle);

/// A cap of hair: from `low` to the crown, `thick` metres off the head; its edge is rounded and reaches into the skin.
mannequin::Skin hair_cap(const std::function<double(double angle)>& low,
                         const std::function<double(double angle, double row)>& thick, std::size_t rings = 7,
                         std::size_t columns = 28);

/// A tube along places, of the given radii; both ends are closed.
mannequin::Skin hair_tube(const std::vector<glm::dvec3>& places, const std::vector<double>& radii,
                          std::size_t around = 10, mannequin::Region region = mannequin::Region::hair);

/// Long hair that comes out below a hat, whose lower edge is a row of the head by angle. It ends at a height behind and
/// at another one at the sides.
mannequin::Skin hair_below_hat(const std::function<double(double angle)>& edge, double bottom, double side_bottom);
/// Hair that is tied at the back of the head and hangs down.
mannequin::Skin tied_tail();

/// Returns the paint by which strands darken and lighten hair around the head.
glm::dvec3 strand_paint(double angle, double along);

/// Weights of hair that hangs: of the head above, of the neck and the chest where it lies on the back.
mannequin::Weights hair_weights(glm::dvec3 place);

}  // namespace throng::wardrobe
