#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"

namespace throng::import {

/// The weights of the morph targets of a node's mesh, as the file has them.
struct WeightKeys {
  anim::Interpolation interpolation = anim::Interpolation::linear;
  std::size_t targets = 0;
  std::vector<float> times;
  std::vector<float> weights;  ///< [key][target]; with cubic_spline [key][in-tangent, weight, out-tangent][target]
};

/// An animation of the file with the tracks of all its nodes.
struct Animation {
  anim::Clip clip;                        ///< without its tracks
  std::map<int, anim::BoneTracks> nodes;  ///< by node; their bone is not set
  std::map<int, WeightKeys> weights;      ///< by node
};

/// Reads every animation, and charges Document::memory. Checks that key times ascend, are finite and match their
/// bounds, that values are finite, that data keys are inside the animation, and that curves have one value a time.
/// Throws Refusal; repairs go to `document`.
std::vector<Animation> read_animations(Document& document, const NodeTree& tree);

/// Returns the morph targets of a node's mesh that any of the animations gives another weight than its own, which
/// `rest_weights` has.
std::vector<int> animated_targets(const std::vector<Animation>& animations, int node,
                                  std::span<const double> rest_weights);

/// Gives the clips of `model` the weights of its morphs, and adds clips for animations that have nothing else for it.
/// Charges `memory`.
void add_morph_tracks(const std::vector<Animation>& animations, anim::Model& model, MemoryAccount& memory);

}  // namespace throng::import
