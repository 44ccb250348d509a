#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/bake/character.h"

namespace throng::anim {

/// Counts the palette entries of each level.
std::vector<std::uint32_t> entries_of_levels(const Skeleton& skeleton);

/// Returns all of a clip but its streams and their owner.
BakedClip without_streams(const BakedClip& clip);

/// Returns a clip whose streams have the bones in the order of `skeleton`; `places` has the new index of each bone.
BakedClip reorder_clip(const BakedClip& clip, const Skeleton& skeleton, std::span<const int> places);

}  // namespace throng::anim
