#include "engine/anim/survey/lod_survey.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

constexpr std::size_t points_a_bone = 16;
constexpr int most_poses = 256;
constexpr float strong_weight = 0.5F;

LodPoint point_of(const Skeleton& skeleton, const SkinnedMesh& mesh, std::size_t vertex) {
  LodPoint point{.position = glm::dvec3(mesh.positions[vertex])};
  for (std::size_t i = 0; i < point.entries.size(); ++i) {
    const auto influence = static_cast<glm::length_t>(i);
    point.entries[i] = mesh.palette_entries[vertex][influence];
    point.weights[i] = static_cast<double>(mesh.weights[vertex][influence]);
  }
  point.bone = skeleton.palette[static_cast<std::size_t>(point.entries[0])].bone;
  return point;
}

std::vector<LodPoint> pick_vertices(const Model& model) {
  std::vector<std::vector<LodPoint>> points(model.skeleton.bones.size());
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      if (mesh.weights[vertex].x < strong_weight) continue;
      const LodPoint point = point_of(model.skeleton, mesh, vertex);
      points[static_cast<std::size_t>(point.bone)].push_back(point);
    }
  }
  std::vector<LodPoint> picked;
  for (const auto& of_bone : points) {
    const std::size_t step = of_bone.size() / points_a_bone + 1;
    for (std::size_t i = 0; i < of_bone.size(); i += step) picked.push_back(of_bone[i]);
  }
  return picked;
}

/// Picks the ends of the bones, which stand for a missing surface.
std::vector<LodPoint> pick_joints(const Skeleton& skeleton) {
  std::vector<LodPoint> points;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.parent(bone);
    if (parent < 0) continue;
    const JointPlace own = joint_place(skeleton, bone), above = joint_place(skeleton, parent);
    if (own.entry < 0) continue;
    const glm::dvec3 length = above.entry < 0 ? glm::dvec3(0.0) : own.position - above.position;
    points.push_back({.bone = bone, .entries = {own.entry}, .weights = {1.0}, .position = own.position + length});
  }
  return points;
}

std::vector<double> surveyed_times(const Model& model, const Clip& clip) {
  const int poses = std::clamp(most_poses / static_cast<int>(model.clips.size()), 2, 16);
  std::vector<double> times;
  for (int i = 0; i < poses; ++i) times.push_back(clip.start + clip.length() * (i + 0.5) / poses);
  return times;
}

/// Keeps the last key at or before each time, and the first one after it.
template <typename Value>
void keep_keys_around(Track<Value>& track, std::span<const double> times) {
  if (track.empty()) return;
  std::vector<bool> is_read(track.times.size() + 1, false);  // and one behind the last, which is none
  for (const double time : times) {
    const auto wide = [](float key) { return static_cast<double>(key); };
    const auto after = std::ranges::upper_bound(track.times, time, {}, wide) - track.times.begin();
    is_read[static_cast<std::size_t>(after)] = true;
    is_read[static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - 1, 0))] = true;
  }
  const std::size_t count = values_a_key(track.interpolation);
  Track<Value> kept{.interpolation = track.interpolation, .times = {}, .values = {}};
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    if (!is_read[key]) continue;
    kept.times.push_back(track.times[key]);
    const std::span values = std::span(track.values).subspan(key * count, count);
    kept.values.insert(kept.values.end(), values.begin(), values.end());
  }
  kept.times.shrink_to_fit();
  kept.values.shrink_to_fit();
  track = std::move(kept);
}

}  // namespace

std::vector<int> first_entries(const Skeleton& skeleton) {
  std::vector<int> first(skeleton.bones.size(), no_entry);
  for (int entry = skeleton.palette_count(); entry-- > 0;) {
    first[static_cast<std::size_t>(skeleton.palette[static_cast<std::size_t>(entry)].bone)] = entry;
  }
  return first;
}

std::vector<LodPoint> pick_lod_points(const Model& model) {
  return model.meshes.empty() ? pick_joints(model.skeleton) : pick_vertices(model);
}

glm::dvec3 skinned(const LodPoint& point, std::span<const glm::dmat4> palette) {
  glm::dvec4 sum(0.0);
  for (std::size_t i = 0; i < point.entries.size(); ++i) {
    if (point.weights[i] == 0.0) continue;
    sum += point.weights[i] * (palette[static_cast<std::size_t>(point.entries[i])] * glm::dvec4(point.position, 1.0));
  }
  return glm::dvec3(sum);
}

void visit_surveyed_poses(const Model& model, const std::function<void(std::span<const glm::dmat4> palette)>& visit) {
  if (model.clips.empty()) return visit(reference_pose(model.skeleton, nullptr, 0.0).palette);
  for (const Clip& clip : model.clips) {
    for (const double time : surveyed_times(model, clip)) visit(reference_pose(model.skeleton, &clip, time).palette);
  }
}

void keep_surveyed_keys(Model& model) {
  for (Clip& clip : model.clips) {
    const std::vector<double> times = surveyed_times(model, clip);
    clip.morph_tracks = {};  // no surveyed pose shows them
    for (BoneTracks& tracks : clip.tracks) {
      keep_keys_around(tracks.translation, times);
      keep_keys_around(tracks.rotation, times);
      keep_keys_around(tracks.scale, times);
    }
  }
}

float percentile_99(std::vector<float> values) {
  if (values.empty()) return 0.0F;
  const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace throng::anim
