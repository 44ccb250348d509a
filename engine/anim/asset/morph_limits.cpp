#include "engine/anim/asset/morph_limits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

namespace {

constexpr int gone = -1;

/// Returns the longest time between two keys, in seconds.
double longest_gap(const std::vector<float>& times) {
  double gap = 0.0;
  for (std::size_t key = 1; key < times.size(); ++key) {
    gap = std::max(gap, static_cast<double>(times[key]) - static_cast<double>(times[key - 1]));
  }
  return gap;
}

/// Returns a weight that the track nowhere exceeds, on either side of 0.
double largest_weight(const MorphTrack& track, std::size_t column) {
  constexpr double bulge = 2.0 * 4.0 / 27.0;  // of a spline, by both its tangents, in a span of a second
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  double weight = 0.0, tangent = 0.0;
  for (std::size_t i = column, row = 0; i < track.weights.size(); i += track.morphs.size(), ++row) {
    double& largest = cubic && row % 3 != 1 ? tangent : weight;
    largest = std::max(largest, static_cast<double>(std::abs(track.weights[i])));
  }
  return weight + (tangent > 0.0 ? bulge * tangent * longest_gap(track.times) : 0.0);
}

/// Returns, for each morph, a weight that no clip exceeds.
std::vector<double> largest_weights(const Model& model) {
  std::vector<double> largest(model.morphs.size(), 0.0);
  for (const Clip& clip : model.clips) {
    for (const MorphTrack& track : clip.morph_tracks) {
      for (std::size_t column = 0; column < track.morphs.size(); ++column) {
        double& weight = largest[static_cast<std::size_t>(track.morphs[column])];
        weight = std::max(weight, largest_weight(track, column));
      }
    }
  }
  return largest;
}

/// Returns how far each morph moves a vertex at most, in the unit of the vertices.
std::vector<double> strengths(const Model& model) {
  std::vector<double> strengths(model.morphs.size(), 0.0);
  for (const SkinnedMesh& mesh : model.meshes) {
    for (const MorphDelta& delta : mesh.morph_deltas) {
      double& strength = strengths[delta.morph];
      strength = std::max(strength, static_cast<double>(glm::length(delta.position)));
    }
  }
  const std::vector<double> weights = largest_weights(model);
  for (std::size_t morph = 0; morph < strengths.size(); ++morph) strengths[morph] *= weights[morph];
  return strengths;
}

/// Returns the new index of each morph, or `gone`.
std::vector<int> kept_places(const std::vector<double>& strengths, std::size_t most) {
  std::vector<std::size_t> order(strengths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return strengths[a] > strengths[b]; });
  order.resize(std::min(order.size(), most));
  std::erase_if(order, [&](std::size_t morph) { return !(strengths[morph] > 0.0); });
  std::ranges::sort(order);
  std::vector<int> places(strengths.size(), gone);
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = static_cast<int>(i);
  return places;
}

void keep_deltas(SkinnedMesh& mesh, const std::vector<int>& places) {
  std::erase_if(mesh.morph_deltas, [&](const MorphDelta& delta) { return places[delta.morph] == gone; });
  for (MorphDelta& delta : mesh.morph_deltas) delta.morph = static_cast<std::uint32_t>(places[delta.morph]);
  std::ranges::sort(mesh.morph_deltas, {},
                    [](const MorphDelta& delta) { return std::pair(delta.vertex, delta.morph); });
}

MorphTrack kept_track(const MorphTrack& track, const std::vector<int>& places) {
  MorphTrack kept{.interpolation = track.interpolation, .morphs = {}, .times = track.times, .weights = {}};
  const auto place_of = [&](std::size_t column) { return places[static_cast<std::size_t>(track.morphs[column])]; };
  for (std::size_t column = 0; column < track.morphs.size(); ++column) {
    if (place_of(column) != gone) kept.morphs.push_back(place_of(column));
  }
  for (std::size_t i = 0; i < track.weights.size(); ++i) {
    if (place_of(i % track.morphs.size()) != gone) kept.weights.push_back(track.weights[i]);
  }
  return kept;
}

void keep_tracks(Clip& clip, const std::vector<int>& places) {
  std::vector<MorphTrack> kept;
  for (const MorphTrack& track : clip.morph_tracks) {
    kept.push_back(kept_track(track, places));
    if (kept.back().morphs.empty()) kept.pop_back();
  }
  clip.morph_tracks = std::move(kept);
}

/// Names the morphs that one could see and that are gone; empty where there are none.
std::string left_out(const std::vector<Morph>& morphs, const std::vector<double>& strengths,
                     const std::vector<int>& places, std::size_t most) {
  constexpr std::size_t most_names = 8;
  std::string names;
  std::size_t count = 0, seen = 0;
  for (std::size_t morph = 0; morph < morphs.size(); ++morph) {
    seen += strengths[morph] > 0.0 ? 1U : 0U;
    if (places[morph] != gone || !(strengths[morph] > 0.0)) continue;
    if (++count <= most_names) names += (names.empty() ? "" : "; ") + morphs[morph].name;
  }
  if (count == 0) return {};
  if (count > most_names) names += "; and " + std::to_string(count - most_names) + " more";
  return "clips animate " + std::to_string(seen) + " morph targets, of which the strongest " + std::to_string(most) +
         " are kept; left out: " + names;
}

/// Returns how much the rest pose enlarges the surface at a vertex, at most.
double largest_scale(const glm::dmat4& entry) {
  const glm::dmat3 linear(entry);
  return std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
}

}  // namespace

std::string limit_morphs(Model& model, std::size_t most) {
  const std::vector<double> strong = strengths(model);
  const std::vector<int> places = kept_places(strong, most);
  std::string sentence = left_out(model.morphs, strong, places, most);
  for (SkinnedMesh& mesh : model.meshes) keep_deltas(mesh, places);
  for (Clip& clip : model.clips) keep_tracks(clip, places);
  std::erase_if(model.clips, [](const Clip& clip) { return clip.tracks.empty() && clip.morph_tracks.empty(); });
  std::vector<Morph> kept;
  for (std::size_t morph = 0; morph < places.size(); ++morph) {
    if (places[morph] != gone) kept.push_back(std::move(model.morphs[morph]));
  }
  model.morphs = std::move(kept);
  return sentence;
}

std::vector<int> morph_bones(const Model& model) {
  std::vector<std::vector<double>> held(model.morphs.size(), std::vector<double>(model.skeleton.bones.size(), 0.0));
  for (const SkinnedMesh& mesh : model.meshes) {
    for (const MorphDelta& delta : mesh.morph_deltas) {
      for (int i = 0; i < 4; ++i) {
        const std::size_t entry = mesh.palette_entries[delta.vertex][i];
        const auto bone = static_cast<std::size_t>(model.skeleton.palette[entry].bone);
        held[delta.morph][bone] += static_cast<double>(mesh.weights[delta.vertex][i]);
      }
    }
  }
  std::vector<int> bones;
  bones.reserve(held.size());
  for (const std::vector<double>& of_morph : held) {
    bones.push_back(static_cast<int>(std::ranges::max_element(of_morph) - of_morph.begin()));
  }
  return bones;
}

double morph_reach(const Model& model) {
  if (model.morphs.empty()) return 0.0;
  const std::vector<double> weights = largest_weights(model);
  const std::vector<glm::dmat4> rest = reference_pose(model.skeleton, nullptr, 0.0).palette;
  double reach = 0.0;
  for (const SkinnedMesh& mesh : model.meshes) {
    std::vector<double> moved(mesh.positions.size(), 0.0);
    for (const MorphDelta& delta : mesh.morph_deltas) {
      const double scale = largest_scale(rest[mesh.palette_entries[delta.vertex].x]);
      moved[delta.vertex] += scale * weights[delta.morph] * static_cast<double>(glm::length(delta.position));
      reach = std::max(reach, moved[delta.vertex]);
    }
  }
  return reach;
}

}  // namespace throng::anim
