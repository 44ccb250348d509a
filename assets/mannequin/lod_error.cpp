#include "assets/mannequin/lod_error.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/geometric.hpp>

#include "assets/mannequin/closest.h"

namespace throng::mannequin {
namespace {

using glm::dvec3;

constexpr std::size_t every_key = 10;
constexpr double near_at_rest = 0.06;  ///< Metres.

double distance_to(dvec3 place, const std::vector<dvec3>& places, const std::array<std::uint16_t, 3>& triangle) {
  const dvec3 a = places[triangle[0]];
  const dvec3 b = places[triangle[1]];
  const dvec3 c = places[triangle[2]];
  const auto shares = closest_on_triangle(place, a, b, c);
  return glm::distance(place, a * shares[0] + b * shares[1] + c * shares[2]);
}

std::vector<dvec3> at_rest(const Mesh& mesh) {
  std::vector<dvec3> places;
  for (const MeshVertex& vertex : mesh.vertices) places.emplace_back(vertex.position);
  return places;
}

std::vector<dvec3> skinned(const Mesh& mesh, const WorldPose& pose) {
  std::vector<dvec3> places;
  for (const MeshVertex& vertex : mesh.vertices) {
    dvec3 sum(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const WorldJoint& joint = pose[vertex.joints[i]];
      const dvec3 offset = dvec3(vertex.position) - skeleton()[vertex.joints[i]].position;
      sum += static_cast<double>(vertex.weights[i]) * (joint.position + joint.rotation * offset);
    }
    places.push_back(sum);
  }
  return places;
}

/// For every vertex of one mesh the triangles of the other that it may be nearest to.
class Neighbourhoods {
 public:
  Neighbourhoods(const Mesh& from, const Mesh& to) : to_(to) {
    const std::vector<dvec3> vertices = at_rest(from);
    const std::vector<dvec3> places = at_rest(to);
    for (const dvec3 vertex : vertices) {
      std::vector<std::size_t>& near = near_.emplace_back();
      double nearest = 1e9;
      for (std::size_t t = 0; t < to.triangles.size(); ++t) {
        const double distance = distance_to(vertex, places, to.triangles[t]);
        if (distance < near_at_rest) near.push_back(t);
        if (distance >= nearest) continue;
        nearest = distance;
        if (near.empty() || nearest >= near_at_rest) near.assign(1, t);
      }
    }
  }

  void measure(const std::vector<dvec3>& from, const std::vector<dvec3>& to, SurfaceError& error, double& sum) const {
    for (std::size_t v = 0; v < from.size(); ++v) {
      double nearest = 1e9;
      for (const std::size_t t : near_[v]) nearest = std::min(nearest, distance_to(from[v], to, to_.triangles[t]));
      error.largest = std::max(error.largest, nearest);
      sum += nearest;
    }
  }

 private:
  const Mesh& to_;
  std::vector<std::vector<std::size_t>> near_;
};

}  // namespace

SurfaceError surface_error(const Mesh& full, const Mesh& coarse, std::span<const Clip> clips) {
  const Neighbourhoods onto_coarse(full, coarse);
  const Neighbourhoods onto_full(coarse, full);
  SurfaceError error;
  double sum = 0;
  std::size_t poses = 0;
  for (const Clip& clip : clips) {
    for (std::size_t key = 0; key < clip.keys.size(); key += every_key, ++poses) {
      const WorldPose pose = world_pose(clip.keys[key]);
      const std::vector<dvec3> fine = skinned(full, pose);
      const std::vector<dvec3> few = skinned(coarse, pose);
      onto_coarse.measure(fine, few, error, sum);
      onto_full.measure(few, fine, error, sum);
    }
  }
  error.mean = sum / static_cast<double>(poses * (full.vertices.size() + coarse.vertices.size()));
  return error;
}

}  // namespace throng::mannequin
