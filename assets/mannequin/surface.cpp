#include "assets/mannequin/surface.h"

#include <algorithm>
#include <map>
#include <utility>

namespace throng::mannequin {
namespace {

using glm::dvec3;

/// A sum of vertices, divided at the end.
struct Blend {
  dvec3 position{0};
  Weights weights{};
  double share = 0;

  void add(const CageVertex& vertex, double amount) {
    position += vertex.position * amount;
    for (std::size_t j = 0; j < joint_count; ++j) weights[j] += vertex.weights[j] * amount;
    share += amount;
  }
  [[nodiscard]] CageVertex vertex() const {
    CageVertex mean{position / share, weights};
    for (double& weight : mean.weights) weight /= share;
    return mean;
  }
};

using EdgeKey = std::pair<std::size_t, std::size_t>;
EdgeKey edge_key(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Vertices in the order: the cage's own, one per face, one per edge.
class Subdivision {
 public:
  explicit Subdivision(const Cage& cage) : cage_(cage), vertices_(cage.vertices) {
    add_face_points();
    add_edge_points();
    move_own_points();
    move_border_points();
  }

  Surface take() {
    Surface surface{std::move(vertices_), {}};
    for (std::size_t f = 0; f < cage_.faces.size(); ++f) {
      cage_.faces[f].straight ? halve(cage_.faces[f], surface) : quarter(f, surface);
    }
    return surface;
  }

 private:
  [[nodiscard]] std::size_t face_point(std::size_t face) const { return cage_.vertices.size() + face; }

  [[nodiscard]] std::size_t edge_point(std::size_t a, std::size_t b) const { return edges_.at(edge_key(a, b)); }

  void quarter(std::size_t f, Surface& surface) const {
    const CageFace& face = cage_.faces[f];
    const std::size_t n = face.corners.size();
    for (std::size_t c = 0; c < n; ++c) {
      const std::size_t corner = face.corners[c];
      const std::size_t next = edge_point(corner, face.corners[(c + 1) % n]);
      const std::size_t last = edge_point(corner, face.corners[(c + n - 1) % n]);
      surface.quads.push_back({{corner, next, face_point(f), last}, face.region, face.paint[c], face.notes});
    }
  }

  void halve(const CageFace& face, Surface& surface) const {
    const auto& c = face.corners;
    const std::size_t near = edge_point(c[0], c[1]);
    const std::size_t far = edge_point(c[2], c[3]);
    surface.quads.push_back({{c[0], near, far, c[3]}, face.region, face.paint[0], face.notes});
    surface.quads.push_back({{near, c[1], c[2], far}, face.region, face.paint[1], face.notes});
  }

  void add_face_points() {
    for (const CageFace& face : cage_.faces) {
      Blend mean;
      for (const std::size_t corner : face.corners) mean.add(cage_.vertices[corner], 1);
      vertices_.push_back(mean.vertex());
    }
  }

  void add_edge_points() {
    std::map<EdgeKey, Blend> blends;
    std::map<EdgeKey, int> sides;
    for (std::size_t f = 0; f < cage_.faces.size(); ++f) {
      const auto& corners = cage_.faces[f].corners;
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t a = corners[c];
        const std::size_t b = corners[(c + 1) % corners.size()];
        Blend& blend = blends[edge_key(a, b)];
        ++sides[edge_key(a, b)];
        blend.add(cage_.vertices[a], 0.5);
        blend.add(cage_.vertices[b], 0.5);
        blend.add(vertices_[face_point(f)], 1);
      }
    }
    for (const auto& [key, blend] : blends) {
      edges_[key] = vertices_.size();
      const bool open = sides[key] == 1;
      vertices_.push_back(open ? middle_of(key) : blend.vertex());
      if (open) border_.push_back(key);
    }
  }

  [[nodiscard]] CageVertex middle_of(const EdgeKey& key) const {
    Blend middle;
    middle.add(cage_.vertices[key.first], 1);
    middle.add(cage_.vertices[key.second], 1);
    return middle.vertex();
  }

  /// A border is a curve of its own: a cubic spline of its vertices. Where more than two open edges meet, it stays.
  void move_border_points() {
    std::map<std::size_t, std::vector<std::size_t>> around;
    for (const auto& [a, b] : border_) {
      around[a].push_back(b);
      around[b].push_back(a);
    }
    for (const auto& [v, ends] : around) {
      Blend moved;
      moved.add(cage_.vertices[v], 6);
      if (ends.size() == 2) {
        for (const std::size_t end : ends) moved.add(cage_.vertices[end], 1);
      }
      vertices_[v] = moved.vertex();
    }
  }

  void move_own_points() {
    std::vector<Blend> faces(cage_.vertices.size());
    std::vector<Blend> middles(cage_.vertices.size());
    for (std::size_t f = 0; f < cage_.faces.size(); ++f) {
      const auto& corners = cage_.faces[f].corners;
      for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t corner = corners[c];
        faces[corner].add(vertices_[face_point(f)], 1);
        middles[corner].add(cage_.vertices[corner], 0.5);
        middles[corner].add(cage_.vertices[corners[(c + 1) % corners.size()]], 0.5);
      }
    }
    for (std::size_t v = 0; v < cage_.vertices.size(); ++v) {
      const double valence = faces[v].share;
      if (valence == 0) continue;
      Blend moved;
      moved.add(faces[v].vertex(), 1);
      moved.add(middles[v].vertex(), 2);
      moved.add(cage_.vertices[v], valence - 3);
      vertices_[v] = moved.vertex();
    }
  }

  const Cage& cage_;
  std::vector<CageVertex> vertices_;
  std::map<EdgeKey, std::size_t> edges_;
  std::vector<EdgeKey> border_;
};

}  // namespace

Surface subdivide(const Cage& cage) { return Subdivision(cage).take(); }

Cage fit(const Cage& authored, int rounds) {
  Cage fitted = authored;
  for (int round = 0; round < rounds; ++round) {
    const Surface surface = subdivide(fitted);
    for (std::size_t v = 0; v < authored.vertices.size(); ++v) {
      fitted.vertices[v].position += authored.vertices[v].position - surface.vertices[v].position;
    }
  }
  return fitted;
}

}  // namespace throng::mannequin
