#include "assets/wardrobe/sewing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "assets/wardrobe/make.h"

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::Skin;
using mannequin::SkinFace;
using mannequin::SkinPoint;

struct Ray {
  dvec3 origin, direction;
};

Ray ray_at(LaidFrom from, dvec2 place) {
  if (from == LaidFrom::left) return {{1, place.y, place.x}, {-1, 0, 0}};
  if (from == LaidFrom::right) return {{-1, place.y, place.x}, {1, 0, 0}};
  if (from == LaidFrom::above) return {{place.x, 1, place.y}, {0, -1, 0}};
  const double side = from == LaidFrom::front ? 1 : -1;
  return {{place.x, place.y, side}, {0, 0, -side}};
}

struct Hit {
  double distance = 1e9;
  std::array<std::size_t, 3> corners{};
  dvec3 shares{0};
};

/// Moeller and Trumbore 1997.
void try_triangle(const Skin& cloth, const Ray& ray, std::array<std::size_t, 3> corners, Hit& best) {
  const dvec3 a = cloth.points[corners[0]].position;
  const dvec3 ab = cloth.points[corners[1]].position - a;
  const dvec3 ac = cloth.points[corners[2]].position - a;
  const dvec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant < 1e-14) return;  // seen from its back
  const dvec3 offset = ray.origin - a;
  const double u = glm::dot(offset, p) / determinant;
  const dvec3 q = glm::cross(offset, ab);
  const double v = glm::dot(ray.direction, q) / determinant;
  const double distance = glm::dot(ac, q) / determinant;
  if (u < -1e-9 || v < -1e-9 || u + v > 1 + 1e-9 || distance <= 0 || distance >= best.distance) return;
  best = {distance, corners, {1 - u - v, u, v}};
}

/// The place of cloth below a place of a piece; nothing where there is no cloth.
std::optional<SkinPoint> below(const Skin& cloth, std::size_t faces, const Ray& ray, double lift) {
  Hit best;
  for (std::size_t f = 0; f < faces; ++f) {
    const auto& c = cloth.faces[f].corners;
    for (std::size_t k = 2; k < c.size(); ++k) try_triangle(cloth, ray, {c[0], c[k - 1], c[k]}, best);
  }
  if (best.distance > 1e8) return std::nullopt;
  SkinPoint point{};
  const auto& [i, j, k] = best.corners;
  const std::array<const SkinPoint*, 3> ends{&cloth.points[i], &cloth.points[j], &cloth.points[k]};
  for (int e = 0; e < 3; ++e) {
    const SkinPoint& end = *ends[static_cast<std::size_t>(e)];
    point.position += end.position * best.shares[e];
    for (std::size_t w = 0; w < point.weights.size(); ++w) point.weights[w] += end.weights[w] * best.shares[e];
  }
  const dvec3 normal =
      glm::normalize(glm::cross(ends[1]->position - ends[0]->position, ends[2]->position - ends[0]->position));
  point.position += normal * lift;
  point.normal = normal;
  return point;
}

Piece mirror_image(const Piece& piece) {
  Piece other = piece;
  for (auto& row : other.rows) {
    std::reverse(row.begin(), row.end());
    if (piece.from == LaidFrom::left) continue;
    for (dvec2& place : row) place.x = -place.x;
  }
  if (piece.from == LaidFrom::left) other.from = LaidFrom::right;
  other.both_sides = false;
  return other;
}

mannequin::FaceNotes notes_of(const Piece& piece) {
  mannequin::FaceNotes notes;
  notes.trim = piece.trim;
  const bool of_legs = piece.region == mannequin::Region::trousers || piece.region == mannequin::Region::shoes;
  notes.chart = of_legs ? mannequin::Chart::by_joints : mannequin::Chart::around_body;
  return notes;
}

/// The piece's own points, row by row; empty when some have no cloth below them.
std::vector<SkinPoint> lay(const Skin& cloth, const Piece& piece) {
  std::vector<SkinPoint> points;
  for (const auto& row : piece.rows) {
    for (const dvec2 place : row) {
      const auto point = below(cloth, cloth.faces.size(), ray_at(piece.from, place), piece.lift);
      if (!point) return {};
      points.push_back(*point);
    }
  }
  return points;
}

/// The border of a grid, counter-clockwise.
std::vector<std::size_t> border(std::size_t rows, std::size_t columns) {
  std::vector<std::size_t> around;
  for (std::size_t c = 0; c < columns; ++c) around.push_back(c);
  for (std::size_t r = 1; r < rows; ++r) around.push_back(r * columns + columns - 1);
  for (std::size_t c = columns - 1; c-- > 0;) around.push_back((rows - 1) * columns + c);
  for (std::size_t r = rows - 1; r-- > 1;) around.push_back(r * columns);
  return around;
}

void add_face(Skin& cloth, std::vector<std::size_t> corners, const Piece& piece, double shade) {
  std::vector<dvec3> paint(corners.size(), dvec3(piece.paint * shade));
  cloth.faces.push_back({std::move(corners), piece.region, std::move(paint), notes_of(piece)});
}

void add_laid(Skin& cloth, const Piece& piece) {
  const std::vector<SkinPoint> points = lay(cloth, piece);
  if (points.empty()) return;
  const std::size_t first = cloth.points.size();
  cloth.points.insert(cloth.points.end(), points.begin(), points.end());
  const std::size_t rows = piece.rows.size();
  const std::size_t columns = piece.rows.front().size();
  for (std::size_t r = 0; r + 1 < rows; ++r) {
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      const std::size_t low = first + r * columns + c;
      add_face(cloth, {low, low + 1, low + columns + 1, low + columns}, piece, 1);
    }
  }
  // The rim has points of its own, so that its edge is sharp.
  const std::vector<std::size_t> around = border(rows, columns);
  const std::size_t rim = cloth.points.size();
  for (const std::size_t at : around) {
    SkinPoint high = points[at];
    SkinPoint low = high;
    low.position -= high.normal * (piece.lift + 0.003);
    cloth.points.push_back(high);
    cloth.points.push_back(low);
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::size_t here = rim + 2 * i;
    const std::size_t next = rim + 2 * ((i + 1) % around.size());
    add_face(cloth, {here + 1, next + 1, next, here}, piece, 0.72);
  }
}

}  // namespace

void sew_on(Skin& cloth, const Piece& piece) {
  add_laid(cloth, piece);
  if (piece.both_sides) add_laid(cloth, mirror_image(piece));
}

std::vector<std::vector<dvec2>> rectangle(dvec2 low, dvec2 high, std::size_t rows, std::size_t columns) {
  std::vector<std::vector<dvec2>> places;
  for (std::size_t r = 0; r <= rows; ++r) {
    places.emplace_back();
    for (std::size_t c = 0; c <= columns; ++c) {
      const dvec2 share(static_cast<double>(c) / static_cast<double>(columns),
                        static_cast<double>(r) / static_cast<double>(rows));
      places.back().push_back(low + (high - low) * share);
    }
  }
  return places;
}

void add_buttons(Skin& cloth, mannequin::Region region, dvec2 high, dvec2 low, int count, double radius, double lift,
                 double paint, double trim) {
  const std::size_t faces = cloth.faces.size();
  Piece look;
  look.region = region;
  look.paint = paint;
  look.trim = trim;
  for (int b = 0; b < count; ++b) {
    const double share = count > 1 ? static_cast<double>(b) / (count - 1) : 0;
    const auto middle = below(cloth, faces, ray_at(LaidFrom::front, high + (low - high) * share), lift);
    if (!middle) continue;
    const dvec3 across = glm::normalize(glm::cross(dvec3(0, 1, 0), middle->normal));
    const dvec3 up = glm::cross(middle->normal, across);
    std::vector<std::size_t> corners;
    for (int c = 0; c < 6; ++c) {
      const double angle = c * std::numbers::pi / 3;
      SkinPoint point = *middle;
      point.position += (across * std::cos(angle) + up * std::sin(angle)) * radius;
      corners.push_back(cloth.points.size());
      cloth.points.push_back(point);
    }
    add_face(cloth, corners, look, 1);
  }
}

void crumple(Skin& cloth, double depth) {
  std::vector<double> hollow(cloth.points.size());
  mannequin::compute_normals(cloth);
  for (std::size_t p = 0; p < cloth.points.size(); ++p) {
    const dvec3 at = cloth.points[p].position;
    const double side = at.x > 0 ? 1 : -1;
    // Two crossing waves, out of step on both sides.
    const double wave = std::sin(61 * at.y + 37 * at.z + 29 * at.x * side + side) * 0.6 +
                        std::sin(-43 * at.y + 71 * at.z + 19 * at.x + 2 * side) * 0.4;
    hollow[p] = std::max(0.0, -wave);
    cloth.points[p].position += cloth.points[p].normal * (wave * depth);
  }
  for (SkinFace& face : cloth.faces) {
    for (std::size_t c = 0; c < face.corners.size(); ++c) face.paint[c] *= 1 - 0.06 * hollow[face.corners[c]];
  }
}

}  // namespace throng::wardrobe
