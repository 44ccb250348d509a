#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "throng/ticks.h"

#include "app/people/crowd/layout.h"
#include "app/people/crowd/minds.h"

namespace throng::app {

/// Lays out companies in rank and file on a closed route of two straights and two ends, and spectators along it. The
/// distance between files is such that on every quarter turn a file walks one whole cycle of the walk clip (or two,
/// ...) more than the file inside it: on the straights all marchers are in step, and no feet slide.
CrowdLayout parade_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

/// Returns the place of a marcher after `seconds`.
LanePoint marcher_place(const Lane& route, const MarcherStart& marcher, double seconds);

/// Returns the phase of the walk clip, 0 to below 1, that a marcher starts with, so that all of its file and rank are
/// in step.
double marcher_phase(const Lane& route, const MarcherStart& marcher, const CharacterRoles& roles);

/// Agents that march in rank and file along a route. They are the agents after the walkers of a crowd.
class Marchers {
 public:
  explicit Marchers(const CrowdLayout& layout)
      : first_(layout.walkers.size()), route_(layout.route), starts_(layout.marchers), behind_(starts_.size()) {}

  std::size_t count() const { return starts_.size(); }
  /// Returns the number of the company of a marcher, counted from 0 at the head of a parade.
  std::uint32_t company(std::size_t marcher) const { return starts_[marcher].company; }

  /// Puts the marchers where they begin.
  void begin(CrowdPlaces& places) const;
  /// Moves the marchers by `dt`, which is above 0, to `now`. An agent that is held stays, and makes up for it later.
  void advance(Ticks dt, Ticks now, const CrowdMinds& minds, CrowdPlaces& places);
  /// Lets the marchers go on at another speed, in metres a second, from where they are `now`.
  void take_speed(double speed, Ticks now);

 private:
  double marching_time(std::size_t marcher, Ticks dt, Ticks now, bool is_held);

  std::size_t first_;  // agent
  Lane route_;
  std::vector<MarcherStart> starts_;
  std::vector<Ticks> behind_;  // [marcher] how late it is at its places
};

/// The size of a parade, in metres.
struct ParadeSize {
  double half_length;  ///< half the length of the route's straights
  double radius;       ///< radius of the route's ends
  double half_width;   ///< from the route to the outermost file
  double outside;      ///< from the route to the last row of spectators away from the loop's middle
  double inside;       ///< from the route to the last row of spectators towards the middle
};
ParadeSize parade_size(std::size_t agents, const CharacterRoles& roles);

}  // namespace throng::app
