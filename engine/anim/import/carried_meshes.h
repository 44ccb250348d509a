#pragma once

#include <vector>

#include "engine/anim/import/document.h"
#include "engine/anim/import/node_tree.h"
#include "engine/anim/import/skeleton_builder.h"

namespace throng::import {

/// Decides which skeleton carries each mesh without a skin that does not hang below a joint. Returns the nodes of those
/// meshes for each group of skins, as group_skins makes them.
///
/// A mesh belongs to the skeleton whose parts hang below the same nodes, else to the nearest, but only if it lies
/// beside that skeleton's body in the rest pose and is not much larger. Anything else is the scenery of a whole scene,
/// which a crowd of characters must not carry along; a repair names it.
std::vector<std::vector<int>> find_carried_meshes(Document& document, const NodeTree& tree,
                                                  const std::vector<FileSkin>& skins,
                                                  const std::vector<std::vector<int>>& groups);

}  // namespace throng::import
