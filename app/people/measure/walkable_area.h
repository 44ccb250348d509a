#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/measure/convex_polygon.h"
#include "engine/tracks/ground_plan.h"

namespace throng::app {

/// The ground that people can walk on: the floors of a plan without holes, obstacles and walls. Where a plan has no
/// floor, the area is all around its obstacles; where it has nothing, the area is everywhere.
class WalkableArea {
 public:
  WalkableArea() = default;
  /// A plan whose lines cross so often that cutting it would take seconds is left out: the area is everywhere.
  explicit WalkableArea(const GroundPlan& plan);

  bool is_everywhere() const { return pieces_.empty(); }

  /// Returns square metres of the part of `cell` that the person can walk to; 0: there is none. `cell` is about the
  /// person, who is at its origin. A person beside the area counts as in its nearest part.
  float area_around(glm::vec2 person, const ConvexPolygon& cell) const;

 private:
  /// A part of the area without corners that point inwards.
  struct Piece {
    std::array<glm::dvec2, 4> corners;  // in order around it; two may be the same
    std::uint32_t first_opening = 0, opening_count = 0;
  };
  /// A line over which a person can walk from a piece to another one.
  struct Opening {
    glm::dvec2 from, to;
    std::uint32_t other;
  };
  class Walk;

  void take_pieces(const GroundPlan& plan);
  void join_pieces();
  void sort_into_squares();
  std::span<const std::uint32_t> pieces_in(std::size_t square) const;
  std::size_t column(double x) const;
  std::size_t row(double z) const;
  std::uint32_t piece_of(glm::dvec2 person, const ConvexPolygon& cell) const;

  std::vector<Piece> pieces_;
  std::vector<Opening> openings_;
  // A grid of squares, and for each the pieces that lie in it.
  glm::dvec2 lowest_{0.0};
  double squares_a_metre_ = 1.0;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_in_square_, in_squares_;
};

}  // namespace throng::app
