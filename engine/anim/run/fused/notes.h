#pragma once

#include <array>
#include <cstddef>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/run/fused/tail_rounds.h"
#include "engine/anim/run/program/pose_program.h"
#include "engine/anim/run/store/tile_scratch.h"

namespace throng::anim {

/// What a PU notes of the blocks in its store while it runs FusedTasks. 137 KiB, so not on the stack: a host's jobs may
/// have small ones.
struct FusedNotes {
  static constexpr std::size_t most_blocks = PoseProgram::max_steps * most_characters;

  /// Where in main memory the blocks of a tile belong, row by row: of the tile on its way out, of the one that is
  /// computed, and of the one on its way in.
  std::array<std::array<std::byte*, most_blocks>, 3> homes;
  std::array<ShownClips, most_blocks> shown;           ///< [step][character], but not of the last step
  std::array<ShownClips, most_characters> shown_last;  ///< [character]
  std::array<Ticks, most_characters> deltas;           ///< [character]
  TailRounds tails;                                    ///< of a strip
};
static_assert(sizeof(FusedNotes) / 1024 == 137);

}  // namespace throng::anim
