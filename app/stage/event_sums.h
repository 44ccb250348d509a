#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/crowd/crowd.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// What everybody met and where everybody was, as sums over a run: level of detail chooses what is posed, and changes
/// none of them.
class EventSums {
 public:
  /// All agents were made anew.
  void reset(std::size_t agents);

  /// After the clock went on from `before`, and before anything else is asked of the agents.
  void add_events(const anim::AnimationSystem& system, anim::Ticks before);
  /// Once a frame.
  void add_places(const Crowd& crowd);

  std::uint64_t events() const { return events_; }
  /// Over each agent's data keys in their order: name, clip and time.
  std::uint64_t event_hash() const;
  /// Over each frame's positions and headings, bit by bit.
  std::uint64_t place_hash() const { return place_hash_; }

 private:
  std::uint64_t events_ = 0, place_hash_ = 0;
  std::vector<std::uint64_t> hashes_;  // [agent]
};

}  // namespace throng::app
