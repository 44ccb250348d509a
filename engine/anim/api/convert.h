#pragma once

#include <cstdint>

#include "throng/ids.h"

#include "engine/anim/bake/character.h"

/// Converts ids of clips and masks to the library's numbers, and back.
namespace throng::detail {

/// Returns the id of a clip that the character has.
inline ClipId id_of(const anim::Character& character, std::uint32_t clip) {
  return {.number = clip, .generation = character.clips[clip].generation};
}
/// Returns the number of a clip or mask as the library counts it: -1 for none.
inline int number_of(ClipId clip) { return static_cast<int>(clip.number); }
inline int number_of(MaskId mask) { return static_cast<int>(mask.number); }
static_assert(static_cast<int>(no_number) == -1);

}  // namespace throng::detail
