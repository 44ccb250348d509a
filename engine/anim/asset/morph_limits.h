#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// The most morphs that clips of one model animate. A face that follows an actor's has 52.
inline constexpr std::size_t most_morphs = 64;

/// Leaves out morphs that no clip moves, or that move no vertex, and all but the strongest `most`: those that move a
/// vertex farthest. Sorts the deltas of each mesh. Clips without any track left go too. Returns a sentence if morphs
/// that one could see were left out, or nothing.
std::string limit_morphs(Model& model, std::size_t most = most_morphs);

/// Returns, for each morph, the bone that holds most of its vertices: a mask counts for the morph as at this bone.
std::vector<int> morph_bones(const Model& model);

/// Returns how far from where it is posed morphs can move a vertex at most, in metres.
double morph_reach(const Model& model);

}  // namespace throng::anim
