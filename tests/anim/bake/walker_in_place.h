#pragma once

#include <algorithm>
#include <cmath>

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {

/// Hips at 1 m and two feet that slide back at `speed` for half a cycle and swing forward in the other half.
inline Model walker_in_place(float speed) {
  Model model = synthetic_model(1, 1);
  Skeleton& skeleton = model.skeleton;
  skeleton.bones.front().rest = {.translation = {0.0F, 1.0F, 0.0F}};
  skeleton.references.front() = {.origin = {0.0, 1.0, 0.0}};
  Clip clip{.name = "clip", .tracks = {}};
  clip.duration = 1.0;
  for (int foot = 0; foot < 2; ++foot) {
    const float aside = foot == 0 ? 0.1F : -0.1F;
    skeleton.bones.push_back({.name = "foot", .parent = 0, .rest = {.translation = {aside, -0.9F, 0.0F}}});
    skeleton.references.push_back({.origin = {0.0, 0.1, 0.0}});
    skeleton.palette.push_back({.bone = foot + 1});
    BoneTracks tracks;
    tracks.bone = foot + 1;
    for (int key = 0; key <= 30; ++key) {
      const float time = static_cast<float>(key) / 30.0F;
      const float cycle = std::fmod(time + 0.5F * static_cast<float>(foot), 1.0F);
      const bool stands = cycle < 0.5F;
      const float lift = stands ? 0.0F : 0.4F * std::min(cycle - 0.5F, 1.0F - cycle);
      tracks.translation.times.push_back(time);
      tracks.translation.values.emplace_back(aside, lift - 0.9F, speed * (stands ? 0.25F - cycle : cycle - 0.75F));
    }
    clip.tracks.push_back(tracks);
  }
  skeleton.level_bone_counts = {3};
  model.clips.assign(1, clip);
  return model;
}

}  // namespace throng::anim
