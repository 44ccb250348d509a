#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "assets/places/mesh_builder.h"

namespace throng::places {

using glm::dvec2;

/// Sides of a box, as bits.
namespace side {
enum Bits : unsigned {
  front = 1,
  back = 2,
  left = 4,
  right = 8,
  top = 16,
  bottom = 32,
  standing = 31,  ///< all but the bottom
  on_wall = 61,   ///< all but the back
  all_sides = 63
};
}  // namespace side

void box(MeshBuilder& builder, dvec3 low, dvec3 high, const Paint& paint, unsigned sides = side::standing);

/// A rectangle that faces +Z.
void panel(MeshBuilder& builder, double x0, double y0, double x1, double y1, double z, const Paint& paint);

/// The same, from one paint below to another above.
void panel(MeshBuilder& builder, double x0, double y0, double x1, double y1, double z, const Paint& low,
           const Paint& high);

/// A moulding along X on a wall that faces +Z: the profile's points are (z, y), from below upwards.
void moulding(MeshBuilder& builder, const std::vector<dvec2>& profile, double x0, double x1, const Paint& paint,
              bool ends = false);

/// A body of revolution about +Y: the profile's points are (radius, y), from below upwards.
/// Its rings keep their edges unless it is `round`.
enum class Turned { faceted, edged, round };
void lathe(MeshBuilder& builder, const std::vector<dvec2>& profile, int sides, const Paint& paint,
           Turned look = Turned::edged, double from_turn = 0);

/// A round or square bar from one point to another.
void bar(MeshBuilder& builder, dvec3 from, dvec3 to, double from_radius, double to_radius, int sides,
         const Paint& paint, bool smooth = true);

/// A flat disc that faces +Y.
void disc(MeshBuilder& builder, double radius, double y, int sides, const Paint& paint, double from_turn = 0);

/// A round or flat arch in a wall that faces +Z.
struct Arch {
  double middle = 0;  ///< x
  double half = 1;    ///< half its width
  double spring = 2;  ///< y where it begins to curve
  double rise = 1;    ///< of its crown above `spring`
  int pieces = 8;
  [[nodiscard]] dvec2 point(int i) const;  ///< (x, y), from left to right
};

/// The wall between an arch and a straight line above.
void wall_over_arch(MeshBuilder& builder, const Arch& arch, double top_y, double z, const Paint& paint);
/// The underside of an arch, and both sides of the opening below it down to `foot`.
void arch_reveal(MeshBuilder& builder, const Arch& arch, double foot, double front_z, double back_z,
                 const Paint& paint);
/// A ring of stones around an arch, `width` wide, that stands out of the wall at `z` by `out`.
void arch_ring(MeshBuilder& builder, const Arch& arch, double width, double z, double out, const Paint& paint,
               bool keystone);
/// The flat surface that fills an arch above its spring.
void arch_panel(MeshBuilder& builder, const Arch& arch, double z, const Paint& paint);

}  // namespace throng::places
