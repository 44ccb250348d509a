#pragma once

#include <span>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// An order of bones whose prefixes are levels of detail (paper 3.2).
struct BoneOrder {
  std::vector<int> bones;         ///< a permutation: place in the order -> index of the bone as given
  std::vector<int> level_counts;  ///< 1 to max_bone_levels prefixes, descending; [0] is the number of bones
};

/// Orders bones level by level, the coarsest level first, parents before children, depth-first inside a level.
///
/// `parents` has each bone's parent, below the bone's own index, or -1.
/// `importance` is the error, in any unit, when a bone and all below it follow its parent (see bone_importance).
/// A parent counts as at least as important as its children.
/// A level ends where importance falls most near the size that it aims at. Equally important bones, such as the fingers
/// of a hand, are therefore kept or dropped together. Bones of no importance, such as the handles of a rig, go first.
BoneOrder order_bones(std::span<const int> parents, std::span<const double> importance);

/// Returns the new index of each bone of an order.
std::vector<int> bone_places(const BoneOrder& order);

/// Returns for each place in the palette the index of the entry that goes there when its skeleton takes an order.
std::vector<int> palette_order(const Skeleton& skeleton, const BoneOrder& order);

/// Brings the skeleton, skins, clips and meshes of a model into an order.
void reorder_bones(Model& model, const BoneOrder& order);

}  // namespace throng::anim
