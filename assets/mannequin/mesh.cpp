#include "assets/mannequin/mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/occlusion.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;
using Triangle = std::array<std::size_t, 3>;

/// The nearest multiple of `step`; never the negative zero, whose sign depends on the last bit of what was rounded.
dvec3 rounded(dvec3 value, double step) { return glm::round(value / step) * step + dvec3(0); }

/// Cut along the shorter diagonal; on a tie along the first, so that both halves of the body agree.
std::array<Triangle, 2> split(const Quad& quad, const std::vector<dvec3>& positions) {
  const auto& c = quad.corners;
  const double first = glm::distance(positions[c[0]], positions[c[2]]);
  const double second = glm::distance(positions[c[1]], positions[c[3]]);
  if (second < first - position_step) return {{{c[0], c[1], c[3]}, {c[1], c[2], c[3]}}};
  return {{{c[0], c[1], c[2]}, {c[0], c[2], c[3]}}};
}

/// Normals weighted by the angle at the vertex, of the quads rather than of the triangles cut from them.
std::vector<dvec3> smooth_normals(const Surface& surface, const std::vector<dvec3>& positions) {
  std::vector<dvec3> normals(positions.size(), dvec3(0));
  for (const Quad& quad : surface.quads) {
    for (std::size_t c = 0; c < 4; ++c) {
      const dvec3 here = positions[quad.corners[c]];
      const dvec3 next = positions[quad.corners[(c + 1) % 4]] - here;
      const dvec3 last = positions[quad.corners[(c + 3) % 4]] - here;
      const dvec3 normal = glm::cross(next, last);
      const double sine = glm::length(normal);
      if (sine > 0) normals[quad.corners[c]] += normal / sine * std::atan2(sine, glm::dot(next, last));
    }
  }
  for (dvec3& normal : normals) {
    if (normal != dvec3(0)) normal = rounded(glm::normalize(normal), normal_step);
  }
  return normals;
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

/// Gives every combination of surface vertex, region and paint its own mesh vertex.
class Assembly {
 public:
  Assembly(const Surface& surface, const std::vector<dvec3>& positions)
      : surface_(surface), positions_(positions), normals_(smooth_normals(surface, positions)) {
    std::vector<Triangle> triangles;
    for (const Quad& quad : surface.quads) {
      for (const Triangle& triangle : split(quad, positions)) triangles.push_back(triangle);
    }
    openness_ = bake_openness(positions, normals_, triangles);
    for (const Quad& quad : surface.quads) {
      for (const Triangle& triangle : split(quad, positions)) add(quad, triangle);
    }
  }
  Mesh take() { return std::move(mesh_); }

 private:
  using Key = std::tuple<std::size_t, Region, double, double, double>;

  void add(const Quad& quad, const Triangle& triangle) {
    std::array<std::uint16_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) corners[c] = vertex(triangle[c], quad);
    mesh_.triangles.push_back(corners);
  }

  std::uint16_t vertex(std::size_t at, const Quad& quad) {
    const Key key{at, quad.region, quad.paint.x, quad.paint.y, quad.paint.z};
    const auto [found, fresh] = known_.try_emplace(key, static_cast<std::uint16_t>(mesh_.vertices.size()));
    if (fresh) {
      MeshVertex made{};
      made.position = positions_[at];
      made.normal = normals_[at];
      strongest_four(surface_.vertices[at].weights, made);
      const dvec3 colour = quad.paint * openness_[at];
      made.colour = {to_byte(colour.x), to_byte(colour.y), to_byte(colour.z), 255};
      made.region = static_cast<float>(quad.region);
      mesh_.vertices.push_back(made);
    }
    return found->second;
  }

  const Surface& surface_;
  const std::vector<dvec3>& positions_;
  std::vector<dvec3> normals_;
  std::vector<double> openness_;
  std::map<Key, std::uint16_t> known_;
  Mesh mesh_;
};

}  // namespace

Mesh make_mesh(const Surface& surface) {
  std::vector<dvec3> positions;
  for (const CageVertex& vertex : surface.vertices) {
    const dvec3 above_ground(vertex.position.x, std::max(vertex.position.y, 0.0), vertex.position.z);
    positions.push_back(rounded(above_ground, position_step));
  }
  return Assembly(surface, positions).take();
}

}  // namespace throng::mannequin
