#include "assets/mannequin/cage.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <set>

#include <glm/geometric.hpp>

namespace throng::mannequin {
namespace {

using glm::dvec3;

bool on_centre(const CageVertex& vertex) { return std::abs(vertex.position.x) < 1e-9; }

dvec3 face_normal(const Cage& cage, const CageFace& face) {
  dvec3 normal(0);
  for (std::size_t c = 0; c < face.corners.size(); ++c) {
    const dvec3 a = cage.vertices[face.corners[c]].position;
    const dvec3 b = cage.vertices[face.corners[(c + 1) % face.corners.size()]].position;
    normal += glm::cross(a, b);
  }
  return normal;
}

Weights mirrored(const Weights& weights) {
  Weights other{};
  for (std::size_t j = 0; j < joint_count; ++j) other[mirrored_joint(j)] = weights[j];
  return other;
}

Weights symmetric(const Weights& weights) {
  Weights both = mirrored(weights);
  for (std::size_t j = 0; j < joint_count; ++j) both[j] = 0.5 * (both[j] + weights[j]);
  return both;
}

using Edge = std::pair<std::size_t, std::size_t>;

/// Directed edges of a region's faces whose twin belongs to another region, in the faces' own winding.
std::vector<Edge> border_edges(const Cage& cage, Region region) {
  std::set<Edge> inside;
  for (const CageFace& face : cage.faces) {
    if (face.region != region) continue;
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
      inside.insert({face.corners[c], face.corners[(c + 1) % face.corners.size()]});
    }
  }
  std::vector<Edge> border;
  for (const Edge& edge : inside) {
    const bool along_centre = on_centre(cage.vertices[edge.first]) && on_centre(cage.vertices[edge.second]);
    if (!inside.contains({edge.second, edge.first}) && !along_centre) border.push_back(edge);
  }
  return border;
}

}  // namespace

Weights bind(std::initializer_list<std::pair<std::string_view, double>> shares) {
  Weights weights{};
  double sum = 0;
  for (const auto& [name, share] : shares) sum += share;
  for (const auto& [name, share] : shares) weights[joint_index(name)] += share / sum;
  return weights;
}

std::size_t Cage::add(dvec3 position, const Weights& weights) {
  vertices.push_back({position, weights});
  return vertices.size() - 1;
}

std::size_t Cage::add_face(std::vector<std::size_t> corners, Region region, dvec3 paint) {
  std::vector<dvec3> paints(corners.size(), paint);
  faces.push_back({std::move(corners), region, std::move(paints), false, notes});
  return faces.size() - 1;
}

void Cage::bridge(std::span<const std::size_t> lower, std::span<const std::size_t> upper, bool closed, Region region,
                  dvec3 paint, bool straight) {
  assert(lower.size() == upper.size());
  const std::size_t count = closed ? lower.size() : lower.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % lower.size();
    const std::size_t face = add_face({lower[i], lower[next], upper[next], upper[i]}, region, paint);
    faces[face].straight = straight;
  }
}

std::size_t Cage::inset(std::size_t face, std::span<const std::size_t> inner, bool straight) {
  const CageFace outer = faces[face];
  assert(inner.size() == outer.corners.size());
  for (std::size_t c = 0; c < inner.size(); ++c) {
    const std::size_t next = (c + 1) % inner.size();
    const std::size_t side =
        add_face({outer.corners[c], outer.corners[next], inner[next], inner[c]}, outer.region, outer.paint[c]);
    faces[side].straight = straight;
  }
  faces[face].corners.assign(inner.begin(), inner.end());
  return face;
}

void Cage::lift(Region region, const std::function<dvec3(dvec3, dvec3)>& displacement) {
  const std::vector<Edge> border = border_edges(*this, region);
  std::map<std::size_t, dvec3> normals;
  for (const CageFace& face : faces) {
    if (face.region != region) continue;
    for (const std::size_t corner : face.corners) normals[corner] += face_normal(*this, face);
  }
  std::map<std::size_t, std::size_t> lifted;
  for (const auto& [a, b] : border) lifted[a] = lifted[b] = 0;
  for (auto& [below, above] : lifted) above = add(vertices[below].position, vertices[below].weights);
  for (const auto& [vertex, normal] : normals) {
    const auto copy = lifted.find(vertex);
    CageVertex& moved = vertices[copy == lifted.end() ? vertex : copy->second];
    dvec3 offset = displacement(moved.position, glm::normalize(normal));
    if (on_centre(moved)) offset.x = 0;
    moved.position += offset;
  }
  for (CageFace& face : faces) {
    if (face.region != region) continue;
    for (std::size_t& corner : face.corners) {
      if (const auto copy = lifted.find(corner); copy != lifted.end()) corner = copy->second;
    }
  }
  for (const auto& [a, b] : border) faces[add_face({a, b, lifted[b], lifted[a]}, region)].straight = true;
}

Cage mirrored(const Cage& half) {
  Cage whole = half;
  std::vector<std::size_t> image(half.vertices.size());
  for (std::size_t v = 0; v < half.vertices.size(); ++v) {
    const CageVertex& vertex = half.vertices[v];
    if (on_centre(vertex)) {
      image[v] = v;
      whole.vertices[v].weights = symmetric(vertex.weights);
    } else {
      image[v] = whole.add({-vertex.position.x, vertex.position.y, vertex.position.z}, mirrored(vertex.weights));
    }
  }
  for (const CageFace& face : half.faces) {
    CageFace other = face;
    for (std::size_t& corner : other.corners) corner = image[corner];
    std::reverse(other.corners.begin(), other.corners.end());
    std::reverse(other.paint.begin(), other.paint.end());
    whole.faces.push_back(std::move(other));
  }
  return whole;
}

}  // namespace throng::mannequin
