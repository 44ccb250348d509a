#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"

namespace throng::import {

/// What an animation does to a node.
struct NodeTracks {
  anim::Track<glm::vec3> translation;
  anim::Track<glm::quat> rotation;
  anim::Track<glm::vec3> scale;
};

/// An animation of the file, all its nodes together.
struct Animation {
  std::string name;
  double start = 0.0;                         ///< seconds, the first key of all channels
  double duration = 0.0;                      ///< seconds, the last key of all channels
  std::map<int, NodeTracks> nodes;            ///< by node
  std::vector<anim::NamedDataKey> data_keys;  ///< by time
};

/// Reads every animation: key times ascending, finite and matching their bounds; values finite; data keys
/// inside the animation. Morph weights only count for the duration. Throws Refusal; repairs go to `document`.
std::vector<Animation> read_animations(Document& document, const NodeTree& tree);

}  // namespace throng::import
