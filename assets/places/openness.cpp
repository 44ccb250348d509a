#include "assets/places/openness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/places/arithmetic.h"

namespace throng::places {
namespace {

constexpr int ray_count = 96;       ///< over the whole sphere
constexpr double strength = 0.65;   ///< of full occlusion
constexpr double clearance = 0.01;  ///< metres

/// A triangle with a box around it.
struct BoxedTriangle {
  making::RayTriangle triangle;
  dvec3 low, high;
};

std::vector<dvec3> ray_directions() {
  std::vector<dvec3> directions;
  for (int i = 0; i < ray_count; ++i) {
    const double y = 1 - (2.0 * i + 1) / ray_count;
    const double radius = std::sqrt(1 - y * y);
    const double turn = i * 0.38196601125;
    directions.emplace_back(radius * cosine(turn), y, radius * sine(turn));
  }
  return directions;
}

std::vector<BoxedTriangle> ray_triangles(const std::vector<Face>& faces) {
  std::vector<BoxedTriangle> triangles;
  const auto add = [&](dvec3 a, dvec3 b, dvec3 c) {
    triangles.push_back({{a, b - a, c - a}, glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  };
  for (const Face& face : faces) {
    if (!face.corners[0].paint.baked) continue;
    const auto& c = face.corners;
    add(c[0].position, c[1].position, c[2].position);
    if (face.count == 4) add(c[0].position, c[2].position, c[3].position);
  }
  return triangles;
}

double openness_at(dvec3 origin, dvec3 normal, const std::vector<BoxedTriangle>& triangles, double reach) {
  static const std::vector<dvec3> directions = ray_directions();
  std::vector<const BoxedTriangle*> near;
  for (const BoxedTriangle& triangle : triangles) {
    const dvec3 gap = glm::max(dvec3(0), glm::max(triangle.low - origin, origin - triangle.high));
    if (glm::dot(gap, gap) < reach * reach) near.push_back(&triangle);
  }
  double closed = 0;
  double total = 0;
  for (const dvec3 direction : directions) {
    const double slope = glm::dot(direction, normal);
    if (slope <= 0.05) continue;
    double distance = reach;
    if (direction.y < 0 && origin.y > 0) distance = std::min(distance, origin.y / -direction.y);
    for (const BoxedTriangle* triangle : near)
      distance = std::min(distance, hit(triangle->triangle, origin, direction, reach));
    closed += slope * (1 - distance / reach);
    total += slope;
  }
  return 1 - strength * closed / total;
}

/// Faces that lie in one plane and have one colour are equally dark where they meet, so that no seam shows.
void even_out(const std::vector<Face>& faces, std::vector<std::array<double, 4>>& open) {
  using Key = std::tuple<double, double, double, double, double, double, double, double>;
  const auto key = [](const Corner& c) {
    return Key{c.position.x, c.position.y, c.position.z,    c.normal.x,
               c.normal.y,   c.normal.z,   c.paint.color.x, c.paint.color.y};
  };
  std::map<Key, std::pair<double, int>> sums;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < faces[f].count; ++c) {
      auto& [sum, count] = sums[key(faces[f].corners[c])];
      sum += open[f][c];
      ++count;
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < faces[f].count; ++c) {
      const auto& [sum, count] = sums[key(faces[f].corners[c])];
      open[f][c] = sum / count;
    }
  }
}

}  // namespace

std::vector<std::array<double, 4>> corner_openness(const std::vector<Face>& faces, double reach) {
  const std::vector<BoxedTriangle> triangles = ray_triangles(faces);
  std::vector<std::array<double, 4>> open(faces.size(), {1, 1, 1, 1});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f];
    if (!face.corners[0].paint.baked) continue;
    dvec3 middle(0);
    for (std::size_t c = 0; c < face.count; ++c) middle += face.corners[c].position / static_cast<double>(face.count);
    for (std::size_t c = 0; c < face.count; ++c) {
      const Corner& corner = face.corners[c];
      const auto from = [&](double metres) {
        const dvec3 inwards = middle - corner.position;
        const double share = std::min(0.6, metres / std::max(glm::length(inwards), 1e-6));
        return openness_at(corner.position + inwards * share + corner.normal * clearance, corner.normal, triangles,
                           reach);
      };
      // What lies upon the corner itself, such as a sill on a wall, must not darken all of the face.
      const double beside = from(0.3);
      const double here = from(0.05);
      open[f][c] = here < 0.45 ? beside : 0.4 * here + 0.6 * beside;
    }
  }
  even_out(faces, open);
  return open;
}

}  // namespace throng::places
