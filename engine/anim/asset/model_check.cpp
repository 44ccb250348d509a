#include "engine/anim/asset/model_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "engine/anim/base/finite.h"

namespace throng::anim {
namespace {

/// Names the first fault, or is empty.
using Fault = std::string;

Fault fault_of_bone(const Skeleton& skeleton, std::size_t index) {
  const Bone& bone = skeleton.bones[index];
  if (bone.parent < -1 || bone.parent >= static_cast<int>(index)) return "its parent is not a bone before it";
  const bool finite = all_finite(bone.rest.translation) && all_finite(bone.rest.rotation) &&
                      all_finite(bone.rest.scale) && all_finite(bone.prefix);
  if (!finite) return "its rest transform is not of finite numbers";
  const ReferenceFrame& reference = skeleton.references[index];
  if (!all_finite(reference.rotation) || !all_finite(reference.origin) || !std::isfinite(reference.scale)) {
    return "its reference is not of finite numbers";
  }
  return {};
}

Fault fault_of_levels(const Skeleton& skeleton) {
  const std::vector<int>& levels = skeleton.level_bone_counts;
  if (levels.empty() || levels.size() > static_cast<std::size_t>(max_bone_levels))
    return "it has no levels, or too many";
  if (levels.front() != skeleton.bone_count()) return "its first level does not have all its bones";
  const bool descend = std::ranges::is_sorted(levels, std::ranges::greater{});
  return descend && levels.back() >= 1 ? "" : "its levels do not descend to at least one bone";
}

Fault fault_of_palette(const Skeleton& skeleton) {
  if (skeleton.palette.empty()) return "it has no palette";
  int before = 0;
  for (std::size_t i = 0; i < skeleton.palette.size(); ++i) {
    const PaletteEntry& entry = skeleton.palette[i];
    if (entry.bone < before || entry.bone >= skeleton.bone_count()) return "its palette is not sorted by its bones";
    if (skeleton.rigid && entry.bone != static_cast<int>(i)) return "its palette does not have one entry a bone";
    if (!all_finite(entry.post)) return "its palette is not of finite numbers";
    before = entry.bone;
  }
  const bool one_each = skeleton.palette.size() == skeleton.bones.size();
  return skeleton.rigid && !one_each ? "its palette does not have one entry a bone" : "";
}

Fault fault_of(const Skeleton& skeleton) {
  if (skeleton.bones.empty()) return "it has no bones";
  if (skeleton.bone_count() > max_bones) {
    return "it has " + std::to_string(skeleton.bone_count()) + " bones, which are more than " +
           std::to_string(max_bones);
  }
  if (skeleton.references.size() != skeleton.bones.size()) return "it does not have one reference a bone";
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    if (const Fault fault = fault_of_bone(skeleton, i); !fault.empty()) {
      return "bone \"" + skeleton.bones[i].name + "\": " + fault;
    }
  }
  if (Fault fault = fault_of_levels(skeleton); !fault.empty()) return fault;
  return fault_of_palette(skeleton);
}

Fault fault_of_times(const std::vector<float>& times, double duration) {
  for (std::size_t key = 0; key < times.size(); ++key) {
    if (!std::isfinite(times[key]) || times[key] < 0.0F) return "a key's time is negative or not finite";
    if (key > 0 && times[key] <= times[key - 1]) return "the times of keys do not ascend";
  }
  constexpr double rounding = 1e-4;
  const bool ends_before = !times.empty() && static_cast<double>(times.back()) > duration * (1 + rounding) + rounding;
  return ends_before ? "the clip's duration ends before a key" : "";
}

template <typename Value>
Fault fault_of_track(const Track<Value>& track, double duration) {
  if (track.values.size() != track.times.size() * values_a_key(track.interpolation)) {
    return "a track does not have one value a key (three with cubic_spline)";
  }
  if (!std::ranges::all_of(track.values, [](const Value& value) { return all_finite(value); })) {
    return "a key's value is not finite";
  }
  return fault_of_times(track.times, duration);
}

Fault fault_of_rotations(const Track<glm::quat>& track) {
  const std::size_t step = values_a_key(track.interpolation);
  for (std::size_t i = step / 2; i < track.values.size(); i += step) {
    if (glm::dot(track.values[i], track.values[i]) < 1e-12F) return "a rotation is zero";
  }
  return {};
}

/// A rigid skeleton's state has no scale: its clips give one number a bone for it.
Fault fault_of_rigid_scales(const Track<glm::vec3>& track) {
  const std::size_t step = values_a_key(track.interpolation);
  for (std::size_t i = step / 2; i < track.values.size(); i += step) {
    const glm::vec3 off = glm::abs(track.values[i] - glm::vec3(track.values[step / 2].x));
    const float most = 1e-3F * std::abs(track.values[step / 2].x);
    if (std::max({off.x, off.y, off.z}) > most) return "it animates the scale of a rigid skeleton";
  }
  return {};
}

Fault fault_of_bone_tracks(const BoneTracks& tracks, const Skeleton& skeleton, double duration) {
  Fault fault = fault_of_track(tracks.translation, duration);
  if (fault.empty()) fault = fault_of_track(tracks.rotation, duration);
  if (fault.empty()) fault = fault_of_track(tracks.scale, duration);
  if (fault.empty()) fault = fault_of_rotations(tracks.rotation);
  if (fault.empty() && skeleton.rigid) fault = fault_of_rigid_scales(tracks.scale);
  return fault;
}

Fault fault_of_morphs(const MorphTrack& track, const Model& model) {
  const auto is_morph = [&](int morph) { return morph >= 0 && static_cast<std::size_t>(morph) < model.morphs.size(); };
  if (!std::ranges::all_of(track.morphs, is_morph)) return "it animates a morph that the model does not have";
  if (track.weights.size() != track.times.size() * track.morphs.size() * values_a_key(track.interpolation)) {
    return "its morphs do not have one weight a key";
  }
  if (!std::ranges::all_of(track.weights, [](float weight) { return std::isfinite(weight); })) {
    return "a morph's weight is not finite";
  }
  return fault_of_times(track.times, std::numeric_limits<double>::infinity());
}

Fault fault_of_curve(const NamedCurve& curve) {
  if (curve.name.empty()) return "a curve has no name";
  const std::string named = "curve \"" + curve.name + "\": ";
  if (curve.times.empty() || curve.values.size() != curve.times.size())
    return named + "it does not have one value a time";
  const auto is_finite = [](float number) { return std::isfinite(number); };
  const bool finite = std::ranges::all_of(curve.times, is_finite) && std::ranges::all_of(curve.values, is_finite);
  const auto not_after = std::ranges::adjacent_find(curve.times, std::greater_equal<>());
  return finite && not_after == curve.times.end() ? Fault{}
                                                  : named + "its times do not ascend, or a number is not finite";
}

Fault fault_of_clip(const Clip& clip, const Model& model) {
  const bool in_order = clip.start >= 0.0 && clip.duration >= clip.start && std::isfinite(clip.duration);
  if (!in_order) return "its start and duration are not seconds in their order";
  int before = -1;
  for (const BoneTracks& tracks : clip.tracks) {
    if (tracks.bone <= before || tracks.bone >= model.skeleton.bone_count()) {
      return "its tracks do not ascend by bones of the skeleton";
    }
    before = tracks.bone;
    if (const Fault fault = fault_of_bone_tracks(tracks, model.skeleton, clip.duration); !fault.empty()) {
      return "bone \"" + model.skeleton.bones[static_cast<std::size_t>(tracks.bone)].name + "\": " + fault;
    }
  }
  for (const NamedDataKey& key : clip.data_keys) {
    if (key.name.empty() || !(key.time >= 0.0 && key.time <= clip.duration))
      return "a data key is nameless or beyond the clip";
  }
  for (const NamedCurve& curve : clip.curves) {
    if (Fault fault = fault_of_curve(curve); !fault.empty()) return fault;
    const auto is_alike = [&](const NamedCurve& other) { return other.name == curve.name; };
    if (std::ranges::count_if(clip.curves, is_alike) > 1) return "it has two curves \"" + curve.name + "\"";
  }
  for (const MorphTrack& track : clip.morph_tracks) {
    if (Fault fault = fault_of_morphs(track, model); !fault.empty()) return fault;
  }
  return {};
}

Fault fault_of_mesh(const SkinnedMesh& mesh, const Model& model) {
  const std::size_t vertices = mesh.positions.size();
  if (mesh.palette_entries.size() != vertices || mesh.weights.size() != vertices) {
    return "it does not have one weight and one palette entry a position";
  }
  const auto is_vertex = [&](std::uint32_t index) { return index < vertices; };
  if (mesh.indices.size() % 3 != 0 || !std::ranges::all_of(mesh.indices, is_vertex)) {
    return "its indices are not triangles of its positions";
  }
  const auto palette = static_cast<unsigned>(model.skeleton.palette_count());
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    if (!all_finite(mesh.positions[vertex]) || !all_finite(mesh.weights[vertex]))
      return "a vertex is not of finite numbers";
    const glm::u16vec4 entries = mesh.palette_entries[vertex];
    if (std::max({entries.x, entries.y, entries.z, entries.w}) >= palette) return "a vertex reads beyond the palette";
  }
  return {};
}

}  // namespace

Status check_model(const Model& model) {
  const std::string of_model = "model \"" + model.skeleton.name + "\": ";
  if (const Fault fault = fault_of(model.skeleton); !fault.empty()) return Error{of_model + fault};
  for (const Clip& clip : model.clips) {
    const Fault fault = fault_of_clip(clip, model);
    if (!fault.empty()) return Error{of_model + "clip \"" + clip.name + "\": " + fault};
  }
  for (const SkinnedMesh& mesh : model.meshes) {
    const Fault fault = fault_of_mesh(mesh, model);
    if (!fault.empty()) return Error{of_model + "mesh \"" + mesh.name + "\": " + fault};
  }
  return Done{};
}

}  // namespace throng::anim
