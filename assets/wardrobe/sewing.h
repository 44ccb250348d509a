#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"

namespace throng::wardrobe {

// These functions sew pockets, plackets, lapels and buttons on smooth cloth.

/// Says from where a piece is laid on the cloth. Its places are (x, height) on front and back, (z, height) at the
/// sides, (x, z) above.
enum class LaidFrom : unsigned char { front, back, left, right, above };

/// A thin piece of cloth, as rows of places from below; rows are of equal length and run to the wearer's left in front
/// and at the back, from front to back at the side.
struct Piece {
  std::vector<std::vector<glm::dvec2>> rows = {};
  LaidFrom from = LaidFrom::front;
  mannequin::Region region = mannequin::Region::shirt;
  double lift = 0.004;  ///< Metres above the cloth.
  double trim = 0;
  double paint = 1;
  bool both_sides = false;  ///< Also mirrored to the other side.
};

/// Lays a piece on a surface and closes its rim towards it. What finds no cloth below it is left out.
void sew_on(mannequin::Skin& cloth, const Piece& piece);

/// A rectangle of rows and columns between two corners.
std::vector<std::vector<glm::dvec2>> rectangle(glm::dvec2 low, glm::dvec2 high, std::size_t rows = 1,
                                               std::size_t columns = 1);

/// Flat buttons of six corners down the front, from `high` to `low`.
void add_buttons(mannequin::Skin& cloth, mannequin::Region region, glm::dvec2 high, glm::dvec2 low, int count,
                 double radius, double lift, double paint = 0.5, double trim = 1);

/// Soft folds: moves the cloth in and out by up to `depth` and shades the hollows.
void crumple(mannequin::Skin& cloth, double depth);

}  // namespace throng::wardrobe
