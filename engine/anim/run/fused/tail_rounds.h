#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// The tails of a strip's programs, in rounds: entities of one layout, each of another character.
class TailRounds {
 public:
  void clear() {
    entity_count_ = 0;
    round_count_ = 0;
  }
  void add(const PosedEntities::Place& place) { places_[entity_count_++] = place; }
  void end_round(const EntityLayout& layout) {
    rounds_[round_count_++] = {&layout, static_cast<std::uint16_t>(entity_count_)};
  }

  std::size_t count() const { return round_count_; }
  std::span<const PosedEntities::Place> places(std::size_t round) const {
    const std::size_t first = round == 0 ? 0 : rounds_[round - 1].end;
    return std::span(places_).subspan(first, rounds_[round].end - first);
  }
  const EntityLayout& layout(std::size_t round) const { return *rounds_[round].layout; }

 private:
  struct Round {
    const EntityLayout* layout;
    std::uint16_t end;
  };
  static constexpr std::size_t most_entities = PoseProgram::max_steps * widest_strip;

  std::array<PosedEntities::Place, most_entities> places_;
  std::array<Round, most_entities> rounds_;
  std::size_t entity_count_ = 0;
  std::size_t round_count_ = 0;
};

}  // namespace throng::anim
