#include "tests/assets/worn_cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "assets/making/triangle.h"
#include "assets/mannequin/clip.h"
#include "assets/wardrobe/body_skin.h"
#include "assets/wardrobe/warp.h"

namespace throng::test {
namespace {

using glm::dvec3;
using mannequin::Mesh;
using mannequin::MeshVertex;
using mannequin::Skin;
using wardrobe::Body;
using wardrobe::Slot;

constexpr double facing = 0.3;  ///< The least cosine between normals that look the same way.

int layer_of(Slot slot) {
  if (slot == Slot::shoes) return 1;
  if (slot == Slot::bottom) return 2;
  if (slot == Slot::top) return 3;
  return slot == Slot::outer ? 4 : 0;
}

bool of_arm(const MeshVertex& vertex) {
  const std::string& joint = mannequin::skeleton()[vertex.joints[0]].name;
  return joint.starts_with("upper_arm") || joint.starts_with("forearm") || joint.starts_with("hand");
}

std::vector<bool> borders(const Skin& skin) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const mannequin::SkinFace& face : skin.faces) {
    for (std::size_t c = 0; c < face.corners.size(); ++c) {
      const auto ends = std::minmax(face.corners[c], face.corners[(c + 1) % face.corners.size()]);
      ++sides[{ends.first, ends.second}];
    }
  }
  std::vector<bool> border(skin.points.size());
  for (const auto& [edge, count] : sides) {
    if (count == 1) border[edge.first] = border[edge.second] = true;
  }
  return border;
}

WornCloth worn(std::string name, int layer, Skin skin, Body body) {
  for (mannequin::SkinPoint& point : skin.points) {
    point.position = wardrobe::warped(body, point.position, point.weights);
    point.weights = wardrobe::warped_weights(body, point.weights);
  }
  mannequin::compute_normals(skin);
  WornCloth cloth{std::move(name), layer, mannequin::make_mesh(skin), {}, {}};
  const std::vector<bool> border = borders(skin);
  for (const MeshVertex& vertex : cloth.mesh.vertices) {
    cloth.border.push_back(border[vertex.point]);
    const double outwards = vertex.position.x * vertex.normal.x + vertex.position.z * vertex.normal.z;
    cloth.inside.push_back(layer > 0 && !of_arm(vertex) && outwards < 0);
  }
  return cloth;
}

dvec3 posed(const MeshVertex& vertex, dvec3 value, bool direction, const mannequin::WorldPose& pose) {
  dvec3 sum(0);
  for (std::size_t i = 0; i < 4; ++i) {
    if (vertex.weights[i] <= 0) continue;
    const mannequin::WorldJoint& joint = pose[vertex.joints[i]];
    const dvec3 rest = mannequin::skeleton()[vertex.joints[i]].position;
    const dvec3 there = direction ? joint.rotation * value : joint.rotation * (value - rest) + joint.position;
    sum += static_cast<double>(vertex.weights[i]) * there;
  }
  return sum;
}

dvec3 normal_of(const Corners& t) { return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]) + dvec3(0, 1e-20, 0)); }

/// Returns how far along a direction a triangle is that looks the same way; nothing if it is not met.
std::optional<double> met(dvec3 origin, dvec3 direction, const Corners& t) {
  if (glm::dot(normal_of(t), direction) < facing) return std::nullopt;
  const dvec3 b = t[1] - t[0], c = t[2] - t[0], offset = origin - t[0];
  const dvec3 p = glm::cross(direction, c);
  const double determinant = glm::dot(b, p);
  if (std::abs(determinant) < 1e-14) return std::nullopt;
  const double u = glm::dot(offset, p) / determinant;
  const dvec3 q = glm::cross(offset, b);
  const double v = glm::dot(direction, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return glm::dot(c, q) / determinant;
}

Corners corners_of(const std::array<std::uint16_t, 3>& triangle, const std::vector<dvec3>& places) {
  return {places[triangle[0]], places[triangle[1]], places[triangle[2]]};
}

}  // namespace

dvec3 nearest_shares(dvec3 place, const Corners& t) { return making::nearest_shares(place, t[0], t[1], t[2]); }

std::vector<dvec3> places_of(const Mesh& mesh, const mannequin::WorldPose& pose) {
  std::vector<dvec3> places;
  for (const MeshVertex& vertex : mesh.vertices) places.push_back(posed(vertex, vertex.position, false, pose));
  return places;
}

WornCloth worn_part(const wardrobe::Part& part, Body body) {
  return worn(part.name, layer_of(part.slot), part.make(), body);
}

WornCloth worn_skin(Slot piece, Body body) {
  Skin skin = wardrobe::body_skin();
  std::erase_if(skin.faces, [&](const auto& face) { return face.notes.piece != static_cast<unsigned char>(piece); });
  return worn(std::string(name_of(piece)), 0, std::move(skin), body);
}

const std::vector<ClipMoment>& clip_moments() {
  static const std::vector<ClipMoment> moments = [] {
    constexpr std::size_t a_clip = 4;
    std::vector<ClipMoment> all;
    for (const mannequin::Clip& clip : mannequin::make_clips()) {
      for (std::size_t k = 0; k < a_clip; ++k) {
        mannequin::Pose pose = clip.keys[clip.keys.size() * k / a_clip];
        pose.root = dvec3(0);
        all.push_back({clip.name, mannequin::world_pose(pose)});
      }
    }
    return all;
  }();
  return moments;
}

CoveredCloth::CoveredCloth(const WornCloth& inner, const WornCloth& outer, Heights heights)
    : inner_(inner), outer_(outer) {
  constexpr double reach = 0.12, farthest = 0.07;
  std::vector<bool> used(inner.mesh.vertices.size());
  for (const auto& triangle : inner.mesh.triangles) {
    for (const auto corner : triangle) used[corner] = true;
  }
  const std::vector<dvec3> places = places_of(outer.mesh, mannequin::world_pose(mannequin::Pose()));
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v] || inner.inside[v] || inner.at_rest(v).y < heights.low || inner.at_rest(v).y > heights.high) continue;
    Below below{v, {}};
    bool covered = false;
    for (std::size_t t = 0; t < outer.mesh.triangles.size(); ++t) {
      const auto& triangle = outer.mesh.triangles[t];
      if (of_arm(outer.mesh.vertices[triangle[0]]) != of_arm(inner.mesh.vertices[v])) continue;
      if (glm::distance(places[triangle[0]], inner.at_rest(v)) > reach) continue;
      below.triangles.push_back(t);
      const auto distance = met(inner.at_rest(v), inner.mesh.vertices[v].normal, corners_of(triangle, places));
      covered = covered || (distance && *distance > -0.0005 && *distance < farthest);
    }
    if (covered) below_.push_back(std::move(below));
  }
}

double CoveredCloth::deepest(const mannequin::WorldPose& pose) const {
  const std::vector<dvec3> places = places_of(outer_.mesh, pose);
  double worst = 0;
  for (const Below& below : below_) {
    const MeshVertex& vertex = inner_.mesh.vertices[below.vertex];
    const dvec3 point = posed(vertex, vertex.position, false, pose);
    const dvec3 normal = glm::normalize(posed(vertex, vertex.normal, true, pose));
    double nearest = 0.04;
    double outside = 0;
    bool hidden = false;
    for (const std::size_t t : below.triangles) {
      const auto& triangle = outer_.mesh.triangles[t];
      const Corners corners = corners_of(triangle, places);
      const auto distance = met(point, normal, corners);
      hidden = hidden || (distance && *distance > 0);
      if (hidden) break;
      const dvec3 shares = nearest_shares(point, corners);
      const dvec3 there = corners[0] * shares.x + corners[1] * shares.y + corners[2] * shares.z;
      if (glm::distance(there, point) >= nearest) continue;
      nearest = glm::distance(there, point);
      bool at_border = true;
      for (int c = 0; c < 3; ++c)
        at_border = at_border && (shares[c] < 1e-6 || outer_.border[triangle[static_cast<std::size_t>(c)]]);
      const dvec3 up = normal_of(corners);
      const double height = glm::dot(point - there, up);
      const bool counts = !at_border && glm::dot(up, normal) >= facing && nearest < height * 1.5;
      outside = counts ? height : 0;
    }
    if (hidden || outside <= worst) continue;
    worst = outside;
    place_ = inner_.at_rest(below.vertex);
  }
  return worst;
}

}  // namespace throng::test
