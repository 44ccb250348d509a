#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace throng::app {

struct CrowdLayout;

/// Says which agents walk together. Companions come right behind their leader in the list of walkers.
struct Company {
  std::vector<std::uint32_t> leaders;  ///< [walker] its leader; of a leader itself; empty: all are alone
  std::vector<float> sides;            ///< [walker] metres of a person to the left of the leader; 0 for leaders

  std::size_t leader(std::size_t walker) const { return leaders.empty() ? walker : leaders[walker]; }
  bool follows(std::size_t walker) const { return leader(walker) != walker; }
  /// Returns the walker after a leader's last companion.
  std::size_t end_of(std::size_t leader) const {
    std::size_t next = leader + 1;
    while (next < leaders.size() && leaders[next] == leader) ++next;
    return next;
  }
};

/// Draws couples and families among walkers that come one after the other on a lane, and puts them beside each other.
void draw_company(CrowdLayout& layout, std::uint32_t seed);

/// Gives some of the loose groups of a plaza something to do together: one takes a picture of the others, or all look
/// at the nearest of `sights` and one takes a picture of it. A person alone waits. Groups stay on their ground.
void draw_gatherings(CrowdLayout& layout, std::span<const glm::dvec2> sights, double spacing, std::uint32_t seed);

}  // namespace throng::app
