#pragma once

#include <memory>

#include "engine/anim/bake/character.h"
#include "engine/base/result.h"

namespace throng::anim {

// Clips come and go as values: a character is never changed, and these functions make another one of it. Each may run
// on any thread, while crowds play its arguments. A clip keeps its place, which is its number, as long as it is
// there. A place that is left is empty until a clip is added, and its generation tells the two apart.

/// Returns the character `base` with the clips of `more`, which has the same skeleton (bake/bone_match.h) but may have
/// its bones in another order. Empty places are filled first, in their order. Skeleton, surface and levels are those of
/// `base`.
///
/// Streams are lent: `base` and `more`, or the lenders of their clips, live as long as a clip of theirs is left. Clips
/// whose bones are in another order get streams of their own.
///
/// Names of data keys and curves keep their index in `base`, and new ones follow. Bounds and the errors of levels cover
/// all clips. Where the surface of `more` is another one, bounds are wider than needed, and the errors of skipped
/// frames are that surface's. Clips keep the weights of morphs if `more` has the same morphs, which are known by
/// their number, their bones and their reach; else they move none.
///
/// Errors: the skeleton is another one, a clip has the name of a clip that is there, or a character cannot be played.
Result<Character> with_clips(const std::shared_ptr<const Character>& base, std::shared_ptr<const Character> more);

/// Returns a character that plays as `from` does. Its clips lend the streams of `from`, and keep `from` alive.
Character lend_character(const std::shared_ptr<const Character>& from);

/// Returns the character `from` where the place of a clip is empty. Streams of the other clips are lent, as above, and
/// measured values stay, so bounds may be wider than needed. Errors: there is no such clip, or it is the last one.
Result<Character> without_clip(const std::shared_ptr<const Character>& from, int clip);

}  // namespace throng::anim
