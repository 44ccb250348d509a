#pragma once

#include "engine/anim/run/fused/tile_in_store.h"
#include "engine/anim/run/fused/tile_lists.h"
#include "engine/anim/run/program/step_walk.h"

namespace throng::anim {

/// Moves the entities of a tile by the deltas of its agents, and says in the lists which clips each shows. It goes step
/// by step through all characters of a run, because their updates do not wait for each other and overlap. `first` is
/// the first step of the first character.
void advance_entities(const TileInStore& tile, StepCursor first, TileLists& lists);

}  // namespace throng::anim
