#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/run/program/tile.h"

namespace throng::anim {

/// The sources that characters of a tile read and none of them owns, each once, in the order in which they are met.
class SharedSources {
 public:
  static constexpr std::size_t most = PoseProgram::max_steps;

  SharedSources() = default;
  explicit SharedSources(std::span<const AgentRun> tile) {
    for (const AgentRun& run : tile) add(*run.program);
  }

  /// Adds a program's shared sources. Returns false if the list has no room for all of them; then it is of no use.
  bool add(const PoseProgram& program) {
    if (program.needs.shared == 0) return true;
    for (const PoseStep& step : program.steps) {
      if (!step.is_shared() || std::ranges::find(all(), step.shared) != all().end()) continue;
      if (count_ == most) return false;
      entities_[count_++] = step.shared;
    }
    return true;
  }

  std::size_t bytes(const EntityPools& pools) const {
    std::size_t bytes = 0;
    for (const Handle entity : all()) bytes += pools.layout(entity).source_bytes();
    return bytes;
  }

  std::span<const Handle> all() const { return {entities_.data(), count_}; }

  /// Returns the block of `entity`, where `first` is the block of the first source.
  template <typename Byte>
  Byte* block(const EntityPools& pools, Handle entity, Byte* first) const {
    for (const Handle other : all()) {
      if (other == entity) break;
      first += pools.layout(other).source_bytes();
    }
    return first;
  }

 private:
  std::array<Handle, most> entities_;
  std::size_t count_ = 0;
};

}  // namespace throng::anim
