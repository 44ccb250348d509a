#include "engine/anim/asset/skeleton_order.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace throng::anim {

namespace {

// Shares of the bones that the coarser levels aim at: 62 bones give about 32, 22 and 14.
constexpr std::array<double, max_bone_levels - 1> level_shares{0.52, 0.355, 0.23};
constexpr int smallest_level = 6;              // a smaller level saves nothing
constexpr double equally_important = 0.02;     // the two sides of a character differ by less
constexpr double largest_useful_share = 0.85;  // of the level above; a larger level is not worth its switch

/// Makes each parent at least as important as its children, since it cannot be dropped before them, and each root as
/// important as any bone, since it has no parent to follow.
std::vector<double> hand_up(std::span<const int> parents, std::span<const double> importance) {
  std::vector<double> result(importance.begin(), importance.end());
  for (std::size_t bone = parents.size(); bone-- > 0;) {
    if (parents[bone] < 0) continue;
    double& parent = result[static_cast<std::size_t>(parents[bone])];
    parent = std::max(parent, result[bone]);
  }
  const double most = std::ranges::max(result);
  for (std::size_t bone = 0; bone < parents.size(); ++bone) {
    if (parents[bone] < 0) result[bone] = most;
  }
  return result;
}

/// Returns how many bones to keep near `target`: it cuts where the sorted importance falls most, so that limbs are kept
/// or dropped whole.
int cut_near(std::span<const double> descending, double target) {
  const int count = static_cast<int>(descending.size());
  const int from = std::max(1, static_cast<int>(target * 0.8));
  const int to = std::min(count - 1, static_cast<int>(target * 1.25));
  int best = count;
  double best_gap = equally_important;
  for (int cut = from; cut <= to; ++cut) {
    const double above = descending[static_cast<std::size_t>(cut) - 1];
    const double gap = above > 0.0 ? 1.0 - descending[static_cast<std::size_t>(cut)] / above : 0.0;
    if (gap > best_gap) {
      best = cut;
      best_gap = gap;
    }
  }
  return best;
}

std::vector<int> level_counts(std::span<const double> descending) {
  const int count = static_cast<int>(descending.size());
  std::vector<int> counts{count};
  for (const double share : level_shares) {
    const int kept = cut_near(descending, share * count);
    if (kept >= smallest_level && kept <= largest_useful_share * counts.back()) counts.push_back(kept);
  }
  return counts;
}

/// Lists bones depth-first, children in the given order: each bone after its parent's subtree so far.
std::vector<int> depth_first(std::span<const int> parents) {
  const auto count = parents.size();
  std::vector<std::vector<int>> children(count + 1);
  for (std::size_t bone = count; bone-- > 0;) {
    const std::size_t parent = parents[bone] < 0 ? count : static_cast<std::size_t>(parents[bone]);
    children[parent].push_back(static_cast<int>(bone));
  }
  std::vector<int> order;
  std::vector<int> pending = children[count];
  while (!pending.empty()) {
    const int bone = pending.back();
    pending.pop_back();
    order.push_back(bone);
    const auto& below = children[static_cast<std::size_t>(bone)];
    pending.insert(pending.end(), below.begin(), below.end());
  }
  return order;
}

/// Returns for each bone the coarsest level that keeps it. Ties go to the parent, which is listed first.
std::vector<int> coarsest_levels(std::span<const int> by_importance, std::span<const int> counts) {
  std::vector<int> levels(by_importance.size(), 0);
  for (std::size_t level = 1; level < counts.size(); ++level) {
    for (const int bone : by_importance.first(static_cast<std::size_t>(counts[level]))) {
      levels[static_cast<std::size_t>(bone)] = static_cast<int>(level);
    }
  }
  return levels;
}

/// Maps old indices of bones or of palette entries to new ones.
using Places = std::vector<int>;

int at(const Places& places, int index) { return places[static_cast<std::size_t>(index)]; }

Places invert(const std::vector<int>& order) {
  Places places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) places[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return places;
}

template <typename Element>
std::vector<Element> permute(std::vector<Element>& elements, const std::vector<int>& order) {
  std::vector<Element> result;
  result.reserve(elements.size());
  for (const int from : order) result.push_back(std::move(elements[static_cast<std::size_t>(from)]));
  return result;
}

void reorder_skeleton(Skeleton& skeleton, const BoneOrder& order, const Places& places,
                      const std::vector<int>& entries) {
  skeleton.bones = permute(skeleton.bones, order.bones);
  skeleton.references = permute(skeleton.references, order.bones);
  skeleton.palette = permute(skeleton.palette, entries);
  for (Bone& bone : skeleton.bones) {
    if (bone.parent >= 0) bone.parent = at(places, bone.parent);
  }
  for (PaletteEntry& entry : skeleton.palette) entry.bone = at(places, entry.bone);
  skeleton.level_bone_counts = order.level_counts;
}

void reorder_clip(Clip& clip, const Places& places) {
  for (BoneTracks& tracks : clip.tracks) tracks.bone = at(places, tracks.bone);
  std::ranges::sort(clip.tracks, {}, &BoneTracks::bone);
}

void reorder_influences(std::vector<SkinnedMesh>& meshes, const Places& entry_places) {
  for (SkinnedMesh& mesh : meshes) {
    for (glm::u16vec4& vertex : mesh.palette_entries) {
      for (int i = 0; i < 4; ++i) vertex[i] = static_cast<std::uint16_t>(at(entry_places, vertex[i]));
    }
  }
}

}  // namespace

BoneOrder order_bones(std::span<const int> parents, std::span<const double> importance) {
  assert(parents.size() == importance.size());
  const std::vector<double> handed_up = hand_up(parents, importance);
  std::vector<int> by_importance(parents.size());
  std::iota(by_importance.begin(), by_importance.end(), 0);
  const auto importance_of = [&](int bone) { return handed_up[static_cast<std::size_t>(bone)]; };
  std::ranges::stable_sort(by_importance, std::ranges::greater{}, importance_of);
  std::vector<double> descending;
  descending.reserve(by_importance.size());
  for (const int bone : by_importance) descending.push_back(importance_of(bone));

  BoneOrder order{.bones = depth_first(parents), .level_counts = level_counts(descending)};
  const std::vector<int> levels = coarsest_levels(by_importance, order.level_counts);
  std::ranges::stable_sort(order.bones, std::ranges::greater{},
                           [&](int bone) { return levels[static_cast<std::size_t>(bone)]; });
  return order;
}

std::vector<int> bone_places(const BoneOrder& order) { return invert(order.bones); }

std::vector<int> palette_order(const Skeleton& skeleton, const BoneOrder& order) {
  const Places places = bone_places(order);
  std::vector<int> entries(skeleton.palette.size());
  std::iota(entries.begin(), entries.end(), 0);
  std::ranges::stable_sort(
      entries, {}, [&](int entry) { return at(places, skeleton.palette[static_cast<std::size_t>(entry)].bone); });
  return entries;
}

void reorder_bones(Model& model, const BoneOrder& order) {
  const Places places = bone_places(order);
  const std::vector<int> entries = palette_order(model.skeleton, order);
  const Places entry_places = invert(entries);
  reorder_skeleton(model.skeleton, order, places, entries);
  for (Skin& skin : model.skins) {
    for (int& bone : skin.bones) bone = at(places, bone);
    for (int& entry : skin.palette_entries) entry = at(entry_places, entry);
  }
  for (Clip& clip : model.clips) reorder_clip(clip, places);
  visit_surfaces(model, [&](std::vector<SkinnedMesh>& meshes) { reorder_influences(meshes, entry_places); });
}

}  // namespace throng::anim
