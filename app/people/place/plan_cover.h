#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/tracks/ground_plan.h"

namespace throng::app {

/// Names the layers on the ground of a plan. `border` becomes a wall where no agent walks, `solid` everywhere.
enum class CoverLayer : std::uint8_t { floor, border, solid, exit };
inline constexpr std::size_t cover_layer_count = 4;

/// Names the drawn parts of a plan.
enum class CoverPart : std::uint8_t { wall, floor, exit };
inline constexpr std::size_t cover_part_count = 3;

/// A piece of a part: two sides that go up from its lowest to its highest line. These may have no length.
struct CoverPiece {
  CoverPart part;
  std::array<glm::dvec2, 2> left, right;   ///< [low, high]
  bool left_is_outline, right_is_outline;  ///< else the part goes on there
};

/// A ring or a line of a plan, in double precision, as it is cut.
using DoubleRing = std::vector<glm::dvec2>;
inline DoubleRing doubled(const std::vector<glm::vec2>& points) { return {points.begin(), points.end()}; }
/// Returns the outline of an area, and then its holes.
std::vector<DoubleRing> rings_of(const GroundArea& area);

/// Returns the direction of the level lines at which pieces begin and end; a turn to the left goes from low to high.
glm::dvec2 cover_direction();

/// Cuts overlapping polygons of any shape into pieces that overlap nowhere.
/// Ground that an odd number of its lines surrounds is in a polygon, so lines that cross or have no area do no harm.
/// The outline sides of all pieces form the outlines of the parts.
class PlanCover {
 public:
  /// Adds a polygon of rings. Rings within others are its holes.
  void add(CoverLayer layer, std::span<const std::vector<glm::dvec2>> rings);
  /// Adds a wall along a line or a closed ring, on both sides of it.
  void add_band(CoverLayer layer, std::span<const glm::dvec2> line, bool is_closed, double half_width);

  /// Cuts all polygons into columns, so that no piece is much wider. Nothing may be added after it.
  void cut_columns(double width);

  /// Returns the pieces; none where lines cross so often that cutting would take more than seconds.
  std::vector<CoverPiece> pieces() const;

 private:
  struct Edge {
    glm::dvec2 low, high;
    std::uint32_t polygon;

    double x_at(double y) const;
  };
  struct Crossing {
    double x;
    std::uint32_t edge;
  };
  struct PieceSide {
    std::uint32_t edge;
    bool is_outline;

    friend auto operator<=>(const PieceSide&, const PieceSide&) = default;
  };
  struct OpenPiece {
    CoverPart part;
    PieceSide left, right;
    double from;
  };

  void add_ring(std::span<const glm::dvec2> ring);
  void add_convex(CoverLayer layer, std::span<const glm::dvec2> ring);
  void add_corner(CoverLayer layer, const std::array<glm::dvec2, 3>& points, double half_width);
  std::vector<double> events() const;
  void cut(std::span<const Crossing> crossings, double from, std::vector<OpenPiece>& pieces) const;
  CoverPiece closed(const OpenPiece& piece, double to) const;

  std::vector<Edge> edges_;         // turned, so that hardly any edge lies level
  std::vector<CoverLayer> layers_;  // [polygon]
};

}  // namespace throng::app
