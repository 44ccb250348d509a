#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/people/crowd/crowd.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// Sums over a run of the data keys and the places of all agents. Level of detail chooses which agents
/// are posed, and changes none of these sums.
class EventSums {
 public:
  /// Begins the sums anew, for `agents` that were made anew.
  void reset(std::size_t agents);

  /// Adds the data keys that the agents met since `before`. Call it when the clock has gone on from there, and before
  /// anything else is asked of the agents.
  void add_events(const anim::AnimationSystem& system, Ticks before);
  /// Adds the places of all agents. Call it once a frame.
  void add_places(const Crowd& crowd);

  std::uint64_t events() const { return events_; }
  /// Returns a hash of each agent's data keys in their order: name, clip and time.
  std::uint64_t event_hash() const;
  /// Returns a hash of each frame's positions and headings, bit by bit.
  std::uint64_t place_hash() const { return place_hash_; }

 private:
  std::uint64_t events_ = 0, place_hash_ = 0;
  std::vector<std::uint64_t> hashes_;  // [agent]
};

}  // namespace throng::app
