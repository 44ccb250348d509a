#include "assets/wardrobe/make.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/wardrobe/body_skin.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Cage;
using mannequin::Skin;
using mannequin::Weights;

constexpr int fitting_rounds = 4;

struct PieceTriangle {
  making::BoundedTriangle bounds;
  Slot piece;
};

std::vector<PieceTriangle> cut_pieces(const Skin& skin) {
  std::vector<PieceTriangle> triangles;
  for (const mannequin::SkinFace& face : skin.faces) {
    for (std::size_t c = 1; c + 1 < face.corners.size(); ++c) {
      const std::array<std::size_t, 3> corners{face.corners[0], face.corners[c], face.corners[c + 1]};
      const auto at = [&](std::size_t k) { return skin.points[corners[k]].position; };
      triangles.push_back({making::bounded(corners, at(0), at(1), at(2)), static_cast<Slot>(face.notes.piece)});
    }
  }
  return triangles;
}

dvec3 face_middle(const Cage& cage, const mannequin::CageFace& face) {
  dvec3 sum(0);
  for (const std::size_t corner : face.corners) sum += cage.vertices[corner].position;
  return sum / static_cast<double>(face.corners.size());
}

/// Normals of a half cage's vertices; along x = 0 they have no x.
std::vector<dvec3> cage_normals(const Cage& cage) {
  std::vector<dvec3> normals(cage.vertices.size(), dvec3(0));
  for (const mannequin::CageFace& face : cage.faces) {
    dvec3 normal(0);
    const std::size_t n = face.corners.size();
    for (std::size_t c = 0; c < n; ++c) {
      normal += glm::cross(cage.vertices[face.corners[c]].position, cage.vertices[face.corners[(c + 1) % n]].position);
    }
    for (const std::size_t corner : face.corners) normals[corner] += normal;
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    if (std::abs(cage.vertices[v].position.x) < 1e-9) normals[v].x = 0;
    if (normals[v] != dvec3(0)) normals[v] = glm::normalize(normals[v]);
  }
  return normals;
}

}  // namespace

const Skin& man_skin() { return body_skin(); }

Weights weights_at(dvec3 place) { return weights_at(place, {}); }

Weights weights_at(dvec3 place, std::initializer_list<Slot> pieces) {
  static const std::vector<PieceTriangle> triangles = cut_pieces(man_skin());
  const auto& points = man_skin().points;
  const auto may_use = [&](const PieceTriangle& triangle) {
    return pieces.size() == 0 || std::ranges::find(pieces, triangle.piece) != pieces.end();
  };
  const auto position = [&](std::size_t point) { return points[point].position; };
  const auto [corners, shares] = making::nearest_place(place, std::span(triangles), position, may_use);
  const auto& [a, b, c] = corners;
  Weights weights{};
  for (std::size_t j = 0; j < mannequin::joint_count; ++j) {
    weights[j] = shares.x * points[a].weights[j] + shares.y * points[b].weights[j] + shares.z * points[c].weights[j];
  }
  return weights;
}

Skin mirrored_surface(const Cage& half) { return whole_surface(mannequin::mirrored(half)); }

Skin whole_surface(const Cage& cage) {
  return mannequin::skin_of(mannequin::subdivide(mannequin::fit(cage, fitting_rounds)));
}

std::vector<std::size_t> add_ring(Cage& cage, std::size_t n, const std::function<dvec3(double)>& place,
                                  const std::function<Weights(dvec3)>& weights) {
  std::vector<std::size_t> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const dvec3 at = place(static_cast<double>(i) / static_cast<double>(n));
    ring.push_back(cage.add(at, weights(at)));
  }
  return ring;
}

Cage shell(std::initializer_list<Slot> pieces, mannequin::Region region, const std::function<double(dvec3)>& lift,
           const std::function<bool(dvec3)>& keep) {
  const Cage& man = man_cage();
  Cage cage;
  std::map<std::size_t, std::size_t> copies;
  const std::vector<dvec3> normals = cage_normals(man);
  for (const mannequin::CageFace& face : man.faces) {
    if (std::find(pieces.begin(), pieces.end(), static_cast<Slot>(face.notes.piece)) == pieces.end()) continue;
    if (!keep(face_middle(man, face))) continue;
    mannequin::CageFace copy = face;
    copy.region = region;
    copy.notes = {};
    copy.paint.assign(face.corners.size(), dvec3(1));
    for (std::size_t& corner : copy.corners) {
      const auto [found, fresh] = copies.try_emplace(corner, cage.vertices.size());
      if (fresh) {
        mannequin::CageVertex vertex = man.vertices[corner];
        vertex.position += normals[corner] * lift(vertex.position);
        cage.vertices.push_back(vertex);
      }
      corner = found->second;
    }
    cage.faces.push_back(std::move(copy));
  }
  return cage;
}

Skin bare_skin(Slot piece, double above) {
  const Skin& man = man_skin();
  Skin bare;
  std::map<std::size_t, std::size_t> copies;
  for (mannequin::SkinFace face : man.faces) {
    if (static_cast<Slot>(face.notes.piece) != piece) continue;
    const auto is_low = [&](std::size_t corner) { return man.points[corner].position.y < above; };
    if (std::any_of(face.corners.begin(), face.corners.end(), is_low)) continue;
    for (std::size_t& corner : face.corners) {
      const auto [found, fresh] = copies.try_emplace(corner, bare.points.size());
      if (fresh) bare.points.push_back(man.points[corner]);
      corner = found->second;
    }
    face.notes = {};
    bare.faces.push_back(std::move(face));
  }
  return bare;
}

void append(Skin& all, const Skin& more) {
  const std::size_t first = all.points.size();
  all.points.insert(all.points.end(), more.points.begin(), more.points.end());
  for (mannequin::SkinFace face : more.faces) {
    for (std::size_t& corner : face.corners) corner += first;
    all.faces.push_back(std::move(face));
  }
}

}  // namespace throng::wardrobe
