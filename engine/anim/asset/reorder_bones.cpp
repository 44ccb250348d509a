#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "engine/anim/asset/skeleton_order.h"

namespace throng::anim {

namespace {

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
  reorder_influences(model.meshes, entry_places);
  for (BakedMeshLod& lod : model.mesh_lods) reorder_influences(lod.meshes, entry_places);
}

}  // namespace throng::anim
