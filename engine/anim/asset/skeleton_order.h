#pragma once

#include <span>
#include <vector>

namespace throng::anim {

/// An order of bones whose prefixes are levels of detail (DESIGN section 7 "Per-bone LOD").
struct BoneOrder {
  std::vector<int> bones;         ///< a permutation: place in the order -> index of the bone as given
  std::vector<int> level_counts;  ///< 1 to max_bone_levels prefixes, descending; [0] is the number of bones
};

/// Orders bones level by level, the coarsest level first, parents before children, depth-first inside a level.
///
/// `parents`: for each bone its parent, below its own index, or -1. `lengths`: for each bone its distance from its
/// parent in the rest pose, any unit, >= 0. What a level drops first is the limb end that reaches least: a bone's reach
/// is its own length and the longest chain below it, so fingers go before toes and toes before hands. Bones of equal
/// reach, such as the two sides of a character, are kept or dropped together.
BoneOrder order_bones(std::span<const int> parents, std::span<const double> lengths);

}  // namespace throng::anim
