#include "engine/anim/survey/surface_points.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include <glm/geometric.hpp>

namespace throng::anim {
namespace {

constexpr std::size_t most_candidates = 20'000;

void add_point(SurfacePoints& points, std::span<const PointInfluence> influences) {
  if (points.firsts.empty()) points.firsts.push_back(0);
  points.influences.insert(points.influences.end(), influences.begin(), influences.end());
  points.firsts.push_back(static_cast<std::uint32_t>(points.influences.size()));
}

void add_vertex(SurfacePoints& points, const SkinnedMesh& mesh, std::size_t vertex) {
  if (points.firsts.empty()) points.firsts.push_back(0);
  const glm::vec4 position(mesh.positions[vertex], 1.0F);
  for (int i = 0; i < 4; ++i) {
    const float weight = mesh.weights[vertex][i];
    if (weight == 0.0F) continue;
    points.influences.push_back({.weighted = weight * position, .entry = mesh.palette_entries[vertex][i]});
  }
  points.firsts.push_back(static_cast<std::uint32_t>(points.influences.size()));
}

SurfacePoints every_nth_vertex(const Model& model, std::size_t stride) {
  SurfacePoints points;
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t v = 0; v < mesh.positions.size(); v += stride) add_vertex(points, mesh, v);
  }
  return points;
}

SurfacePoints joints(const Skeleton& skeleton) {
  SurfacePoints points;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const JointPlace place = joint_place(skeleton, bone);
    if (place.entry < 0) continue;
    const PointInfluence whole{.weighted = glm::vec4(glm::vec3(place.position), 1.0F),
                               .entry = static_cast<std::uint32_t>(place.entry)};
    add_point(points, {&whole, 1});
  }
  return points;
}

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Returns for each bone that carries any candidate the one farthest from its joint.
std::vector<std::size_t> outermost(const Skeleton& skeleton, const ReferencePose& rest, const SurfacePoints& candidates,
                                   std::span<const glm::dvec3> at) {
  std::vector<std::size_t> found(skeleton.bones.size(), none);
  std::vector<double> farthest(skeleton.bones.size(), -1.0);
  for (std::size_t point = 0; point < candidates.count(); ++point) {
    if (candidates.of(point).empty()) continue;
    const auto bone = static_cast<std::size_t>(main_bone(skeleton, candidates.of(point)));
    const double distance = glm::distance(at[point], glm::dvec3(rest.globals[bone][3]));
    if (distance <= farthest[bone]) continue;
    farthest[bone] = distance;
    found[bone] = point;
  }
  std::erase(found, none);
  return found;
}

/// Chooses the candidate that is farthest from all chosen so far, again and again.
class FarthestFirst {
 public:
  explicit FarthestFirst(std::span<const glm::dvec3> at)
      : at_(at), distance_(at.size(), std::numeric_limits<double>::max()) {}

  void choose(std::size_t point) {
    chosen_.push_back(point);
    for (std::size_t i = 0; i < at_.size(); ++i) {
      distance_[i] = std::min(distance_[i], glm::distance(at_[i], at_[point]));
    }
  }
  /// Returns false if all others lie where chosen ones do.
  bool choose_next(std::span<const std::size_t> among) {
    const auto distance = [this](std::size_t point) { return distance_[point]; };
    const auto farthest = std::ranges::max_element(among, {}, distance);
    if (farthest == among.end() || distance_[*farthest] <= 0.0) return false;
    choose(*farthest);
    return true;
  }
  const std::vector<std::size_t>& chosen() const { return chosen_; }

 private:
  std::span<const glm::dvec3> at_;
  std::vector<double> distance_;  // to the nearest chosen point
  std::vector<std::size_t> chosen_;
};

}  // namespace

SurfacePoints sample_surface(const Model& model, std::size_t most) {
  std::size_t vertices = 0;
  for (const SkinnedMesh& mesh : model.meshes) vertices += mesh.positions.size();
  return vertices == 0 ? joints(model.skeleton) : every_nth_vertex(model, std::max<std::size_t>(1, vertices / most));
}

int main_bone(const Skeleton& skeleton, std::span<const PointInfluence> influences) {
  const auto weight = [](const PointInfluence& influence) { return influence.weighted.w; };
  return skeleton.palette[std::ranges::max_element(influences, {}, weight)->entry].bone;
}

std::vector<glm::dvec3> places(const SurfacePoints& points, const ReferencePose& pose) {
  std::vector<glm::dvec3> places;
  for (std::size_t point = 0; point < points.count(); ++point) {
    glm::dvec4 place(0.0);
    for (const PointInfluence& influence : points.of(point)) {
      place += pose.palette[influence.entry] * glm::dvec4(influence.weighted);
    }
    places.emplace_back(place);
  }
  return places;
}

SurfacePoints choose_surface_points(const Model& model, std::size_t most) {
  assert(most >= 1 && most <= most_surface_points);
  const SurfacePoints candidates = sample_surface(model, most_candidates);
  const ReferencePose rest = reference_pose(model.skeleton, nullptr, 0.0);
  const std::vector<glm::dvec3> at = places(candidates, rest);
  const std::vector<std::size_t> ends = outermost(model.skeleton, rest, candidates, at);
  std::vector<std::size_t> all(candidates.count());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;

  FarthestFirst choice(at);
  while (choice.chosen().size() < std::min(most, ends.size()) && choice.choose_next(ends)) {
  }
  while (choice.chosen().size() < most && choice.choose_next(all)) {
  }
  SurfacePoints points;
  for (const std::size_t point : choice.chosen()) add_point(points, candidates.of(point));
  return points;
}

}  // namespace throng::anim
