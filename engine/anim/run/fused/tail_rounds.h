#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/fused/composed_run.h"
#include "engine/anim/run/fused/tile_in_store.h"

namespace throng::anim {

/// The tails of the programs of a strip, in rounds. A step of a tail reads only the step before it, and changes
/// the pose where it lies. A round has entities of one layout, each of another character; one call poses them.
class TailRounds {
 public:
  /// Makes room for as many entities as a tile has blocks. Allocates.
  void reserve(std::size_t blocks);
  std::size_t bytes() const;

  /// Sorts the tails of these runs into rounds and leaves their cursors at the end. The rounds of steps that need whole
  /// poses, and the entities before them, are first.
  void sort(const Strip& strip, std::span<ComposedRun> composed);

  std::size_t count() const { return round_count_; }
  std::span<const PosedEntities::Place> entities(std::size_t round) const {
    const std::size_t first = round == 0 ? 0 : rounds_[round - 1].end;
    return std::span(entities_).subspan(first, rounds_[round].end - first);
  }
  const EntityLayout& layout(std::size_t round) const { return *rounds_[round].layout; }
  /// Returns the quads whose bones the tails may move.
  std::uint64_t displaced_quads() const { return displaced_quads_; }

  /// Poses the rounds of whole poses, on the packets that are held. `first` is the pose of the first character.
  void pose_whole(const Strip& strip, const PoseView& first) const;
  /// Poses one packet: in all rounds if it is streamed, and in the rounds after the whole poses if it is held.
  void pose_packet(const Strip& strip, const PoseView& first, int packet) const;

 private:
  struct Round {
    const EntityLayout* layout;
    std::uint32_t end;
  };
  using EndOfSteps = std::size_t (*)(const PoseProgram& program);

  void add_rounds(const Strip& strip, std::span<ComposedRun> composed, EndOfSteps end);
  PosedEntities entities_of(const Strip& strip, const PoseView& first, std::size_t round) const;

  std::vector<PosedEntities::Place> entities_;
  std::vector<Round> rounds_;
  std::size_t entity_count_ = 0;
  std::size_t round_count_ = 0;
  std::size_t whole_rounds_ = 0;
  std::uint64_t displaced_quads_ = 0;
};

}  // namespace throng::anim
