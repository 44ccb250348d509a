#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/anim/entity/entity_run.h"
#include "engine/anim/run/fused/tail_rounds.h"
#include "engine/anim/run/program/tile.h"

namespace throng::anim {

/// The clips that each entity of a tile shows.
struct ShownBySteps {
  std::span<ShownClips> entities;  ///< [own step][character]; the clips of the last step are in `last` instead
  std::span<ShownClips> last;      ///< [character]

  std::span<ShownClips> row(std::size_t own_step, const AgentRun& run) const {
    return entities.subspan(own_step * last.size() + run.first, run.count);
  }
  const ShownClips& of(std::size_t own_step, std::size_t character) const {
    return entities[own_step * last.size() + character];
  }
};

/// The lists that a PU keeps of the tiles in its store. They lie beside the store. They are as long as a fetch buffer
/// can hold blocks.
struct TileLists {
  /// The main-memory addresses of the blocks of a tile, row by row. There are three lists, because one tile is on its
  /// way out and one on its way in while a third is computed.
  std::array<std::vector<std::byte*>, 3> origins;
  std::vector<ShownClips> shown;                       ///< see shown_by
  std::array<ShownClips, most_characters> shown_last;  ///< [character]
  std::array<Ticks, most_characters> deltas;           ///< [character]
  TailRounds tails;                                    ///< the tails of the strip that is posed

  /// Makes the lists long enough for fetch buffers of this size. Allocates.
  void reserve(std::size_t fetch_bytes);
  std::size_t bytes() const;

  ShownBySteps shown_by(std::size_t characters) { return {shown, std::span(shown_last).first(characters)}; }
};

}  // namespace throng::anim
