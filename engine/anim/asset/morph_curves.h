#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// The weights of some morphs over the time of a baked clip. Before the first key and after the last, the nearest
/// holds.
struct MorphCurve {
  Interpolation interpolation = Interpolation::linear;
  std::vector<std::uint32_t> morphs;  ///< indices among Model::morphs
  std::vector<Ticks> times;           ///< ascending, at least one
  std::vector<float> weights;         ///< as MorphTrack has them
};

/// Holds the weights that a clip gives to the morphs of its character. A morph without a curve keeps weight 0.
using MorphCurves = std::vector<MorphCurve>;

/// Makes the curves of a clip whose time 0 is `start` seconds of the file. Leaves out morphs that stay at 0, and keeps
/// one key of a weight that stands still.
MorphCurves bake_morph_curves(const Clip& clip, double start);

/// Adds `share` times the weights at `time` to `weights`, one for each of the character's morphs from `first` on.
/// The curves of other morphs are left out.
void add_morph_weights(const MorphCurves& curves, Ticks time, float share, std::span<float> weights,
                       std::uint32_t first = 0);

}  // namespace throng::anim
