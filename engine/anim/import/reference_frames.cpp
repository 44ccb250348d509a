#include "engine/anim/import/reference_frames.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "engine/anim/import/rigid_candidate.h"

namespace throng::import {

namespace {

using anim::Skeleton;
using anim::Skin;

/// The palette entries of the general path: one for each bone and inverse bind, sorted by bone.
class GeneralPalette {
 public:
  explicit GeneralPalette(const Skeleton& skeleton) : entries_of_bone_(skeleton.bones.size()) {}

  int find_or_add(int bone, const glm::dmat4& post) {
    auto& entries = entries_of_bone_[static_cast<std::size_t>(bone)];
    for (const int entry : entries) {
      if (palette_[static_cast<std::size_t>(entry)].post == post) return entry;
    }
    entries.push_back(static_cast<int>(palette_.size()));
    palette_.push_back({.bone = bone, .post = post});
    return entries.back();
  }

  /// Moves the entries to the skeleton and adapts the entry numbers of the skins.
  void store(Skeleton& skeleton, std::vector<Skin>& skins) const {
    std::vector<int> place(palette_.size());
    skeleton.palette.clear();
    for (const auto& entries : entries_of_bone_) {
      for (const int entry : entries) {
        place[static_cast<std::size_t>(entry)] = skeleton.palette_count();
        skeleton.palette.push_back(palette_[static_cast<std::size_t>(entry)]);
      }
    }
    for (Skin& skin : skins) {
      for (int& entry : skin.palette_entries) entry = place[static_cast<std::size_t>(entry)];
    }
  }

 private:
  std::vector<anim::PaletteEntry> palette_;
  std::vector<std::vector<int>> entries_of_bone_;
};

void set_general(Skeleton& skeleton, std::vector<Skin>& skins, const std::vector<int>& attached_bones) {
  skeleton.rigid = false;
  skeleton.references.assign(skeleton.bones.size(), {});
  GeneralPalette palette(skeleton);
  for (Skin& skin : skins) {
    skin.bind_to_model = glm::dmat4(1.0);
    skin.palette_entries.clear();
    for (std::size_t joint = 0; joint < skin.bones.size(); ++joint) {
      skin.palette_entries.push_back(palette.find_or_add(skin.bones[joint], skin.inverse_binds[joint]));
    }
  }
  for (const int bone : attached_bones) palette.find_or_add(bone, glm::dmat4(1.0));
  palette.store(skeleton, skins);
}

void drop_scale_tracks(std::vector<anim::Clip>& clips) {
  for (anim::Clip& clip : clips) {
    for (anim::BoneTracks& tracks : clip.tracks) tracks.scale = {};
    std::erase_if(clip.tracks,
                  [](const anim::BoneTracks& tracks) { return tracks.translation.empty() && tracks.rotation.empty(); });
  }
}

}  // namespace

void set_reference_frames(Skeleton& skeleton, std::vector<Skin>& skins, std::vector<anim::Clip>& clips,
                          const std::vector<int>& attached_bones) {
  set_general(skeleton, skins, attached_bones);
  auto rigid = make_rigid_candidate(skeleton, skins, clips);
  if (!rigid || !shows_the_same(*rigid, skeleton, skins, clips)) return;
  skeleton = std::move(rigid->skeleton);
  skins = std::move(rigid->skins);
  drop_scale_tracks(clips);
}

int plain_palette_entry(const Skeleton& skeleton, int bone) {
  if (skeleton.rigid) return bone;
  const auto plain = std::ranges::find_if(skeleton.palette, [&](const anim::PaletteEntry& entry) {
    return entry.bone == bone && entry.post == glm::dmat4(1.0);
  });
  return static_cast<int>(plain - skeleton.palette.begin());
}

}  // namespace throng::import
