#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/pose_program.h"

namespace throng::anim {

/// The tails of a tile's programs, in rounds: entities of one kind, each of another character.
class TailRounds {
 public:
  void clear() {
    entity_count_ = 0;
    round_count_ = 0;
  }
  void add(const EntityInStore& entity, const PoseView& pose) { entities_[entity_count_++] = {entity, pose}; }
  void end_round() { ends_[round_count_++] = static_cast<std::uint16_t>(entity_count_); }

  std::size_t count() const { return round_count_; }
  std::span<const PosedEntity> round(std::size_t index) const {
    const std::size_t first = index == 0 ? 0 : ends_[index - 1];
    return std::span(entities_).subspan(first, ends_[index] - first);
  }

 private:
  static constexpr std::size_t most_entities = PoseProgram::max_steps * widest_tile;

  std::array<PosedEntity, most_entities> entities_;
  std::array<std::uint16_t, most_entities> ends_;
  std::size_t entity_count_ = 0;
  std::size_t round_count_ = 0;
};

}  // namespace throng::anim
