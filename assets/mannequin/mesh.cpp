#include "assets/mannequin/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/shape.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;
using Triangle = std::array<std::size_t, 3>;

/// The nearest multiple of `step`; never the negative zero, whose sign depends on the last bit of what was rounded.
dvec3 rounded_floats(dvec3 value, double step) { return glm::round(value / step) * step + dvec3(0); }

/// Cuts off the corner whose neighbours are nearest to each other, until a triangle is left. On a tie the first, so
/// that both halves of the body agree.
void cut(std::vector<std::size_t> corners, const std::vector<SkinPoint>& points, std::vector<Triangle>& triangles) {
  for (std::size_t n = corners.size(); n > 3; --n) {
    std::size_t best = 1;
    double shortest = 1e9;
    for (std::size_t i = 1; i <= n; ++i) {
      const double length = glm::distance(points[corners[(i - 1) % n]].position, points[corners[(i + 1) % n]].position);
      if (length >= shortest - position_step) continue;
      shortest = length;
      best = i % n;
    }
    triangles.push_back({corners[(best + n - 1) % n], corners[best], corners[(best + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(best));
  }
  triangles.push_back({corners[0], corners[1], corners[2]});
}

void strongest_four(const Weights& weights, MeshVertex& vertex) {
  std::array<std::size_t, joint_count> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return weights[a] > weights[b] + 1e-9; });
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += weights[order[i]];
  int left = 256;
  for (std::size_t i = 3; i > 0; --i) {
    const int steps = static_cast<int>(std::lround(weights[order[i]] / sum * 256));
    vertex.joints[i] = static_cast<std::uint8_t>(steps > 0 ? order[i] : 0);
    vertex.weights[i] = static_cast<float>(steps * weight_step);
    left -= steps;
  }
  vertex.joints[0] = static_cast<std::uint8_t>(order[0]);
  vertex.weights[0] = static_cast<float>(left * weight_step);
}

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

/// Gives every combination of point, region and paint its own mesh vertex.
class Assembly {
 public:
  explicit Assembly(const Skin& skin) : skin_(skin), shapes_(shapes_of(skin)) {
    for (const SkinFace& face : skin.faces) add(face);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  using Key = std::tuple<std::size_t, Region, unsigned char, double, double, double, double, double, double>;

  void add(const SkinFace& face) {
    std::vector<Triangle> triangles;
    cut(face.corners, skin_.points, triangles);
    for (const Triangle& triangle : triangles) {
      std::array<std::uint16_t, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) {
        const auto corner = std::find(face.corners.begin(), face.corners.end(), triangle[c]) - face.corners.begin();
        corners[c] = vertex(face, static_cast<std::size_t>(corner));
      }
      mesh_.triangles.push_back(corners);
    }
  }

  std::uint16_t vertex(const SkinFace& face, std::size_t corner) {
    const std::size_t at = face.corners[corner];
    const dvec3 paint = face.paint[corner];
    const glm::dvec2 pattern = face.pattern.empty() ? glm::dvec2(0) : face.pattern[corner];
    const auto [found, fresh] = known_.try_emplace(
        Key{at, face.region, face.notes.piece, paint.x, paint.y, paint.z, face.notes.trim, pattern.x, pattern.y},
        static_cast<std::uint16_t>(mesh_.vertices.size()));
    if (!fresh) return found->second;
    const SkinPoint& point = skin_.points[at];
    MeshVertex made{};
    made.position = rounded_floats(point.position, position_step);
    made.normal = point.normal;
    strongest_four(point.weights, made);
    const dvec3 colour = paint * point.openness;
    made.colour = {to_byte(colour.x), to_byte(colour.y), to_byte(colour.z), 255};
    made.region = static_cast<float>(face.region);
    made.point = static_cast<std::uint32_t>(at);
    made.trim = static_cast<float>(face.notes.trim);
    made.pattern = pattern;
    made.piece = face.notes.piece;
    made.shape = glm::round(shapes_[at].body / shape_step) * shape_step + dvec3(0);
    made.hair = glm::round(shapes_[at].hair / shape_step) * shape_step + glm::dvec2(0);
    mesh_.vertices.push_back(made);
    return found->second;
  }

  const Skin& skin_;
  std::vector<Shape> shapes_;
  std::map<Key, std::uint16_t> known_;
  Mesh mesh_;
};

}  // namespace

Skin skin_of(const Surface& surface) {
  Skin skin;
  for (const CageVertex& vertex : surface.vertices) {
    const dvec3 above_ground(vertex.position.x, std::max(vertex.position.y, 0.0), vertex.position.z);
    skin.points.push_back({.position = rounded_floats(above_ground, position_step), .weights = vertex.weights});
  }
  for (const Quad& quad : surface.quads) {
    skin.faces.push_back(
        {{quad.corners.begin(), quad.corners.end()}, quad.region, std::vector<dvec3>(4, quad.paint), quad.notes});
  }
  return skin;
}

std::vector<Triangle> triangles_of(const Skin& skin) {
  std::vector<Triangle> triangles;
  for (const SkinFace& face : skin.faces) cut(face.corners, skin.points, triangles);
  return triangles;
}

void compute_normals(Skin& skin) {
  std::vector<dvec3> normals(skin.points.size(), dvec3(0));
  for (const SkinFace& face : skin.faces) {
    const std::size_t n = face.corners.size();
    for (std::size_t c = 0; c < n; ++c) {
      const dvec3 here = skin.points[face.corners[c]].position;
      const dvec3 next = skin.points[face.corners[(c + 1) % n]].position - here;
      const dvec3 last = skin.points[face.corners[(c + n - 1) % n]].position - here;
      const dvec3 normal = glm::cross(next, last);
      const double sine = glm::length(normal);
      if (sine > 0) normals[face.corners[c]] += normal / sine * std::atan2(sine, glm::dot(next, last));
    }
  }
  for (std::size_t p = 0; p < normals.size(); ++p) {
    skin.points[p].normal =
        normals[p] == dvec3(0) ? normals[p] : rounded_floats(glm::normalize(normals[p]), normal_step);
  }
}

Mesh make_mesh(const Skin& skin) { return Assembly(skin).take(); }

}  // namespace throng::mannequin
