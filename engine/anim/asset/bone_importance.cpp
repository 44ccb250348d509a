#include "engine/anim/asset/bone_importance.h"

#include <algorithm>
#include <cstddef>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

constexpr std::size_t points_a_bone = 16;
constexpr int most_poses = 256;
constexpr float strong_weight = 0.5F;

/// A point that moves with one bone, in the space in which the bone's motion is the identity in the rest pose.
struct SurfacePoint {
  int bone = 0;
  glm::dvec3 position{0.0};
};

/// Bone motions of a pose: what takes a point from where the rest pose has it to where the pose has it.
class Motions {
 public:
  explicit Motions(const Skeleton& skeleton) : skeleton_(skeleton), rest_(reference_pose(skeleton, nullptr, 0.0)) {
    for (const glm::dmat4& global : rest_.globals) {
      const bool invertible = std::abs(glm::determinant(glm::dmat3(global))) > 0.0;
      from_rest_.push_back(invertible ? glm::inverse(global) : glm::dmat4(1.0));
    }
  }

  const ReferencePose& rest() const { return rest_; }

  std::vector<glm::dmat4> at(const Clip& clip, double seconds) const {
    std::vector<glm::dmat4> motions = reference_pose(skeleton_, &clip, seconds).globals;
    for (std::size_t bone = 0; bone < motions.size(); ++bone) motions[bone] = motions[bone] * from_rest_[bone];
    return motions;
  }

 private:
  const Skeleton& skeleton_;
  ReferencePose rest_;
  std::vector<glm::dmat4> from_rest_;
};

/// Vertices of each bone that it holds strongly, spread over the mesh.
std::vector<SurfacePoint> pick_surface(const Model& model, const ReferencePose& rest) {
  std::vector<std::vector<SurfacePoint>> points(model.skeleton.bones.size());
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      if (mesh.weights[vertex].x < strong_weight) continue;
      const std::size_t entry = mesh.palette_entries[vertex].x;
      const int bone = model.skeleton.palette[entry].bone;
      const glm::dvec3 position(rest.palette[entry] * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
      points[static_cast<std::size_t>(bone)].push_back({.bone = bone, .position = position});
    }
  }
  std::vector<SurfacePoint> picked;
  for (const auto& of_bone : points) {
    const std::size_t step = of_bone.size() / points_a_bone + 1;
    for (std::size_t i = 0; i < of_bone.size(); i += step) picked.push_back(of_bone[i]);
  }
  return picked;
}

/// Without a surface, the ends of the bones stand for it.
std::vector<SurfacePoint> pick_joints(const Skeleton& skeleton, const ReferencePose& rest) {
  std::vector<SurfacePoint> points;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
    if (parent < 0) continue;
    const glm::dvec3 own(rest.globals[static_cast<std::size_t>(bone)][3]);
    const glm::dvec3 above(rest.globals[static_cast<std::size_t>(parent)][3]);
    points.push_back({.bone = bone, .position = own + (own - above)});
  }
  return points;
}

void add_distances(const Skeleton& skeleton, const ReferencePose& rest, const std::vector<SurfacePoint>& points,
                   std::vector<double>& importance) {
  for (const SurfacePoint& point : points) {
    for (int bone = point.bone; bone >= 0; bone = skeleton.bones[static_cast<std::size_t>(bone)].parent) {
      const auto index = static_cast<std::size_t>(bone);
      importance[index] =
          std::max(importance[index], glm::distance(point.position, glm::dvec3(rest.globals[index][3])));
    }
  }
}

void add_errors(const Skeleton& skeleton, const std::vector<glm::dmat4>& motions,
                const std::vector<SurfacePoint>& points, std::vector<double>& importance) {
  for (const SurfacePoint& point : points) {
    const glm::dvec4 position(point.position, 1.0);
    const glm::dvec3 there(motions[static_cast<std::size_t>(point.bone)] * position);
    for (int bone = point.bone; bone >= 0;) {
      double& own = importance[static_cast<std::size_t>(bone)];
      bone = skeleton.bones[static_cast<std::size_t>(bone)].parent;
      const glm::dvec3 followed(bone < 0 ? position : motions[static_cast<std::size_t>(bone)] * position);
      own = std::max(own, glm::distance(there, followed));
    }
  }
}

}  // namespace

std::vector<double> bone_importance(const Model& model) {
  const Skeleton& skeleton = model.skeleton;
  const Motions motions(skeleton);
  const auto points =
      model.meshes.empty() ? pick_joints(skeleton, motions.rest()) : pick_surface(model, motions.rest());
  std::vector<double> importance(skeleton.bones.size(), 0.0);
  if (model.clips.empty()) {
    add_distances(skeleton, motions.rest(), points, importance);
    return importance;
  }
  const int poses = std::clamp(most_poses / static_cast<int>(model.clips.size()), 2, 16);
  for (const Clip& clip : model.clips) {
    for (int i = 0; i < poses; ++i) {
      add_errors(skeleton, motions.at(clip, clip.duration * (i + 0.5) / poses), points, importance);
    }
  }
  return importance;
}

}  // namespace throng::anim
