#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/memory/model_memory.h"
#include "engine/anim/import/node_tree.h"

namespace throng::import {

/// The tracks of one node in an animation.
struct NodeTracks {
  anim::Track<glm::vec3> translation;
  anim::Track<glm::quat> rotation;
  anim::Track<glm::vec3> scale;

  anim::BoneTracks of_bone(int bone) && {
    return {.bone = bone,
            .translation = std::move(translation),
            .rotation = std::move(rotation),
            .scale = std::move(scale)};
  }
  std::uint64_t bytes() const { return bytes_of(translation) + bytes_of(rotation) + bytes_of(scale); }
};

/// The weights of the morph targets of a node's mesh, as the file has them.
struct WeightKeys {
  anim::Interpolation interpolation = anim::Interpolation::linear;
  std::size_t targets = 0;
  std::vector<float> times;
  std::vector<float> weights;  ///< [key][target]; with cubic_spline [key][in-tangent, weight, out-tangent][target]
};

/// An animation of the file with the tracks of all its nodes.
struct Animation {
  std::string name;
  double start = 0.0;                         ///< seconds, the first key of all channels with two keys or more
  double duration = 0.0;                      ///< seconds, the last key of all channels
  std::map<int, NodeTracks> nodes;            ///< by node
  std::map<int, WeightKeys> weights;          ///< by node
  std::vector<anim::NamedDataKey> data_keys;  ///< by time
  std::vector<anim::NamedCurve> curves;       ///< by name
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
