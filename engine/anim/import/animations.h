#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"

namespace throng::import {

/// The tracks of one node in an animation.
struct NodeTracks {
  anim::Track<glm::vec3> translation;
  anim::Track<glm::quat> rotation;
  anim::Track<glm::vec3> scale;
};

/// An animation of the file with the tracks of all its nodes.
struct Animation {
  std::string name;
  double start = 0.0;                         ///< seconds, the first key of all channels with two keys or more
  double duration = 0.0;                      ///< seconds, the last key of all channels
  std::map<int, NodeTracks> nodes;            ///< by node
  std::vector<anim::NamedDataKey> data_keys;  ///< by time
};

/// Reads every animation. Checks that key times ascend, are finite and match their bounds, that values are finite, and
/// that data keys are inside the animation. Morph weights count for the duration alone. Throws Refusal; repairs go to
/// `document`.
std::vector<Animation> read_animations(Document& document, const NodeTree& tree);

}  // namespace throng::import
