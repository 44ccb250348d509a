#include "app/people/place/plan_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/people/crowd/numbers/turn.h"
#include "app/people/place/plan_cover.h"

namespace throng::app {
namespace {

using Triangle = std::array<glm::vec3, 3>;

constexpr double line_half_width = 0.04;
constexpr float floor_height = -0.003F, exit_height = -0.002F, plan_line_height = -0.001F;  // metres
constexpr double least_cell = 1.0, least_wall_step = 3.0, most_cells = 6'000.0;

/// Linear bytes.
struct Paint {
  std::uint8_t red, green, blue;
};
constexpr Paint wall_side{150, 145, 135}, wall_top{222, 218, 208}, floor_paint{60, 64, 70}, exit_paint{10, 72, 26},
    line_paint{205, 62, 14};

/// Adds flat triangles, none longer than a length, because haze and the crowd's shade are known at corners alone.
class PlanBuilder {
 public:
  PlanBuilder() { mesh_.name = "plan", mesh_.lods.emplace_back(); }

  void add(const Triangle& corners, const glm::vec3& normal, const Paint& paint, float longest) {
    std::size_t first = 0;  // of the longest side
    std::array<float, 3> lengths{};
    for (std::size_t i = 0; i < 3; ++i) lengths.at(i) = glm::distance(corners.at(i), corners.at((i + 1) % 3));
    for (std::size_t i = 1; i < 3; ++i) first = lengths.at(i) > lengths.at(first) ? i : first;
    const glm::vec3 &a = corners.at(first), &b = corners.at((first + 1) % 3), &c = corners.at((first + 2) % 3);
    const glm::vec3 middle = 0.5F * (a + b);
    const float rest = std::max(glm::distance(a, middle), glm::distance(middle, b));
    // Far from the origin no number lies between two neighbours, and halving would never end.
    const bool is_halved = rest < 0.75F * lengths.at(first);
    if (lengths.at(first) <= longest || !is_halved) return add_whole(corners, normal, paint);
    add({a, middle, c}, normal, paint, longest);
    add({middle, b, c}, normal, paint, longest);
  }
  /// Adds a level or upright quad of corners in order around it, half of which may have no area.
  void add_quad(const std::array<glm::vec3, 4>& corners, const glm::vec3& normal, const Paint& paint, float longest) {
    add({corners[0], corners[1], corners[2]}, normal, paint, longest);
    add({corners[0], corners[2], corners[3]}, normal, paint, longest);
  }
  render::SceneryMeshData take() { return std::move(mesh_); }

 private:
  void add_whole(Triangle corners, const glm::vec3& normal, const Paint& paint) {
    const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (glm::dot(across, across) < 1e-16F) return;
    if (glm::dot(across, normal) < 0.0F) std::swap(corners[1], corners[2]);  // the front is seen
    for (const glm::vec3& corner : corners) {
      mesh_.lods.front().indices.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
      mesh_.vertices.push_back({.position = {corner.x, corner.y, corner.z},
                                .normal = {normal.x, normal.y, normal.z},
                                .color = {paint.red, paint.green, paint.blue, 255}});
    }
  }

  render::SceneryMeshData mesh_;
};

double area_of(const DoubleRing& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  }
  return 0.5 * std::abs(twice);
}

/// Counts the lines and areas to draw.
struct PlanSize {
  std::size_t lines = 0;
  double length = 0.0, area = 0.0;  // metres, square metres

  void add(const std::vector<glm::vec2>& points) {
    lines += points.size();
    for (std::size_t i = 1; i < points.size(); ++i)
      length += static_cast<double>(glm::distance(points[i - 1], points[i]));
  }
  void add(const GroundArea& whole) {
    area += area_of(doubled(whole.outline));
    add(whole.outline);
    for (const GroundRing& hole : whole.holes) add(hole);
  }
  /// The longest side of a triangle on the ground, and of a triangle of a wall.
  float ground_step() const {
    return static_cast<float>(std::max({least_cell, std::sqrt(area / most_cells), length / most_cells}));
  }
  float wall_step() const { return static_cast<float>(std::max(least_wall_step, length / most_cells)); }
};

PlanSize size_of(const GroundPlan& plan) {
  PlanSize size;
  for (const GroundArea& area : plan.floors) size.add(area);
  for (const GroundArea& area : plan.exits) size.add(area);
  for (const GroundRing& ring : plan.obstacles) size.add(ring);
  for (const GroundLine& line : plan.walls) size.add(line.points);
  for (const GroundLine& line : plan.measurement_lines) size.add(line.points);
  return size;
}

// A floor has walls around it and blocks in its holes; they end where agents walk.
void add_floor(const GroundArea& area, PlanCover& cover) {
  constexpr double least_area = 1e-4;  // square metres
  const std::vector<DoubleRing> rings = rings_of(area);
  cover.add(CoverLayer::floor, rings);
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    const bool is_flat = area_of(rings[ring]) < least_area;
    cover.add_band(CoverLayer::border, rings[ring], true, plan_wall_thickness * (is_flat ? 0.5 : 1.0));
    if (ring > 0) cover.add(CoverLayer::border, std::span(rings).subspan(ring, 1));
  }
}

PlanCover cover_of(const GroundPlan& plan) {
  PlanCover cover;
  for (const GroundArea& area : plan.floors) add_floor(area, cover);
  for (const GroundRing& obstacle : plan.obstacles) {
    const DoubleRing ring = doubled(obstacle);
    cover.add(CoverLayer::solid, std::span(&ring, 1));
    if (area_of(ring) < 1e-4) cover.add_band(CoverLayer::solid, ring, true, 0.5 * plan_wall_thickness);
  }
  for (const GroundLine& line : plan.walls) {
    cover.add_band(CoverLayer::solid, doubled(line.points), false, 0.5 * plan_wall_thickness);
  }
  for (const GroundArea& area : plan.exits) cover.add(CoverLayer::exit, rings_of(area));
  return cover;
}

glm::vec3 raised(const glm::dvec2& at, float height) {
  return {static_cast<float>(at.x), height, static_cast<float>(at.y)};
}

void add_level(const CoverPiece& piece, float height, const Paint& paint, float longest, PlanBuilder& builder) {
  builder.add_quad({raised(piece.left[0], height), raised(piece.right[0], height), raised(piece.right[1], height),
                    raised(piece.left[1], height)},
                   {0.0F, 1.0F, 0.0F}, paint, longest);
}

struct PlanShape {
  float wall_height, wall_step, ground_step;
};

void add_side(const std::array<glm::dvec2, 2>& side, double outwards, const PlanShape& shape, PlanBuilder& builder) {
  const glm::dvec2 way = side[1] - side[0];
  const double length = glm::length(way);
  if (length < 1e-6) return;
  const glm::dvec2 normal = outwards * glm::dvec2(way.y, -way.x) / length;
  builder.add_quad({raised(side[0], floor_height), raised(side[1], floor_height), raised(side[1], shape.wall_height),
                    raised(side[0], shape.wall_height)},
                   raised(normal, 0.0F), wall_side, shape.wall_step);
}

void add_piece(const CoverPiece& piece, const PlanShape& shape, PlanBuilder& builder) {
  switch (piece.part) {
    case CoverPart::floor:
      return add_level(piece, floor_height, floor_paint, shape.ground_step, builder);
    case CoverPart::exit:
      return add_level(piece, exit_height, exit_paint, shape.ground_step, builder);
    case CoverPart::wall:
      add_level(piece, shape.wall_height, wall_top, shape.wall_step, builder);
      if (piece.left_is_outline) add_side(piece.left, -1.0, shape, builder);
      if (piece.right_is_outline) add_side(piece.right, 1.0, shape, builder);
  }
}

void add_line(const GroundLine& line, float cell, PlanBuilder& builder) {
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const glm::dvec2 from = line.points[i], to = line.points[i + 1];
    const double length = glm::distance(from, to);
    if (length < 1e-6) continue;
    const glm::dvec2 along = line_half_width * (to - from) / length, aside(-along.y, along.x);
    builder.add_quad({raised(from - along - aside, plan_line_height), raised(to + along - aside, plan_line_height),
                      raised(to + along + aside, plan_line_height), raised(from - along + aside, plan_line_height)},
                     {0.0F, 1.0F, 0.0F}, line_paint, cell);
  }
}

}  // namespace

std::size_t plan_lines(const GroundPlan& plan) { return size_of(plan).lines; }

render::SceneryMeshData plan_mesh(const GroundPlan& plan, float wall_height) {
  PlanBuilder builder;
  const PlanSize size = size_of(plan);
  if (size.lines > most_plan_lines) return builder.take();
  const float ground_step = size.ground_step(), wall_step = size.wall_step();
  PlanCover cover = cover_of(plan);
  cover.cut_columns(2.0 * static_cast<double>(ground_step));
  for (const CoverPiece& piece : cover.pieces()) add_piece(piece, {wall_height, wall_step, ground_step}, builder);
  for (const GroundLine& line : plan.measurement_lines) add_line(line, ground_step, builder);
  return builder.take();
}

}  // namespace throng::app
