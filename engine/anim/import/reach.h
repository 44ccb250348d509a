#pragma once

#include <vector>

#include "engine/anim/import/animations.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/skeleton_builder.h"

namespace throng::import {

/// Refuses a file whose numbers are finite one by one, but whose joints could lie further away or be larger, in the
/// rest pose or under any mix of its keys, than a palette of floats can say. Throws Refusal with the node's name.
void check_reach(const Document& document, const NodeTree& tree, const std::vector<Animation>& animations,
                 const std::vector<FileSkin>& skins);

}  // namespace throng::import
