#pragma once

#include <string>
#include <vector>

#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {

/// Returns a synthetic model whose clips are named "clip 0", "clip 1" and so on.
inline Model named_model(int bones, int clips) {
  Model model = synthetic_model(bones, clips);
  for (std::size_t clip = 0; clip < model.clips.size(); ++clip) model.clips[clip].name = "clip " + std::to_string(clip);
  return model;
}

/// Returns the model with the clips [first, last) alone, as a file of some of its clips has it.
inline Model part_of(Model model, int first, int last) {
  model.clips = {model.clips.begin() + first, model.clips.begin() + last};
  return model;
}

/// Returns an order in which every bone comes after its parent, but the last ones first.
inline BoneOrder other_order(const Skeleton& skeleton) {
  BoneOrder order{.bones = {}, .level_counts = {skeleton.bone_count(), skeleton.bone_count() / 2}};
  std::vector<bool> is_placed(skeleton.bones.size(), false);
  while (order.bones.size() < skeleton.bones.size()) {
    for (int bone = skeleton.bone_count(); bone-- > 0;) {
      const int parent = skeleton.bones[static_cast<std::size_t>(bone)].parent;
      if (is_placed[static_cast<std::size_t>(bone)]) continue;
      if (parent >= 0 && !is_placed[static_cast<std::size_t>(parent)]) continue;
      is_placed[static_cast<std::size_t>(bone)] = true;
      order.bones.push_back(bone);
    }
  }
  return order;
}

}  // namespace throng::anim
