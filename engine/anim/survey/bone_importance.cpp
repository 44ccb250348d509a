#include "engine/anim/survey/bone_importance.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/anim/survey/lod_survey.h"

namespace throng::anim {

namespace {

/// Visits the bones that carry a point, from the bone that holds it up to a root.
template <typename Visit>
void for_each_bone_above(const Skeleton& skeleton, int bone, Visit&& visit) {
  for (; bone >= 0; bone = skeleton.parent(bone)) visit(static_cast<std::size_t>(bone));
}

/// Raises the error of every bone above each point to the distance that dropping the bone moves the point in this pose.
void widen_errors(const Skeleton& skeleton, std::span<const int> entries, std::span<const LodPoint> points,
                  std::span<const glm::dmat4> palette, std::span<float> errors) {
  for (const LodPoint& point : points) {
    const glm::dvec4 bound(point.position, 1.0);
    const glm::dvec3 there(palette[static_cast<std::size_t>(point.entries[0])] * bound);
    for_each_bone_above(skeleton, point.bone, [&](std::size_t bone) {
      const int parent = skeleton.bones[bone].parent;
      const int entry = parent < 0 ? no_entry : entries[static_cast<std::size_t>(parent)];
      if (parent >= 0 && entry == no_entry) return;  // nothing is skinned to the parent; bones above it decide
      const glm::dvec3 followed(parent < 0 ? bound : palette[static_cast<std::size_t>(entry)] * bound);
      errors[bone] = std::max(errors[bone], static_cast<float>(glm::distance(there, followed)));
    });
  }
}

std::vector<double> farthest_points(const Model& model) {
  std::vector<double> distances(model.skeleton.bones.size(), 0.0);
  for (const LodPoint& point : pick_lod_points(model)) {
    for_each_bone_above(model.skeleton, point.bone, [&](std::size_t bone) {
      const JointPlace joint = joint_place(model.skeleton, static_cast<int>(bone));
      if (joint.entry < 0) return;
      distances[bone] = std::max(distances[bone], glm::distance(point.position, joint.position));
    });
  }
  return distances;
}

}  // namespace

std::vector<double> bone_errors(const Model& model) {
  const Skeleton& skeleton = model.skeleton;
  const std::vector<LodPoint> points = pick_lod_points(model);
  const std::vector<int> entries = first_entries(skeleton);
  std::vector<std::vector<float>> by_bone(skeleton.bones.size());
  std::vector<float> of_pose(skeleton.bones.size());
  visit_surveyed_poses(model, [&](std::span<const glm::dmat4> palette) {
    std::ranges::fill(of_pose, 0.0F);
    widen_errors(skeleton, entries, points, palette, of_pose);
    for (std::size_t bone = 0; bone < of_pose.size(); ++bone) by_bone[bone].push_back(of_pose[bone]);
  });
  std::vector<double> errors;
  errors.reserve(by_bone.size());
  for (std::vector<float>& of_bone : by_bone) errors.push_back(static_cast<double>(percentile_99(std::move(of_bone))));
  return errors;
}

std::vector<double> bone_importance(const Model& model) {
  return model.clips.empty() ? farthest_points(model) : bone_errors(model);
}

}  // namespace throng::anim
