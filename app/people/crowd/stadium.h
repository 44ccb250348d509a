#pragma once

#include <cstddef>
#include <vector>

#include "throng/ticks.h"

#include "app/people/crowd/cast.h"
#include "app/people/crowd/layout.h"
#include "app/people/crowd/minds.h"

namespace throng::app {

/// Lays out tiers of seats around a field, the lowest at its level, all facing inwards, and athletes on lanes round the
/// field. With `wave_seconds`, a wave runs round the tiers.
CrowdLayout stadium_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

/// A row of seats.
struct StadiumTier {
  Lane lane;  ///< of the feet of people who sit
  std::size_t seats;
  double height;  ///< metres above the field
};
/// Returns all tiers, the lowest first.
std::vector<StadiumTier> stadium_tiers(std::size_t agents, const CharacterRoles& roles);
/// Returns the place of the feet before a seat, facing the field.
LanePoint stadium_seat(const StadiumTier& tier, std::size_t seat);

/// A wave of cheering that goes round the standers of a crowd again and again.
class Wave {
 public:
  Wave() = default;  ///< there is no wave
  /// Expects the wave of `layout`. How unevenly standers rise is drawn from their whims.
  Wave(const CrowdLayout& layout, CrowdMinds& minds);

  /// Lets the agents that the front has reached rise and cheer.
  void advance(Ticks now, const CrowdCast& cast, CrowdMinds& minds);

 private:
  std::size_t first_stander_ = 0;  // agent
  Ticks period_{};
  std::vector<Ticks> next_;  // [stander] when the wave is there
};

/// The size of a stadium, in metres.
struct StadiumSize {
  double half_length, half_width;  ///< half sizes of the lowest tier, along x and z
  double depth, height;            ///< sizes of all tiers together
};
StadiumSize stadium_size(std::size_t agents, const CharacterRoles& roles);

}  // namespace throng::app
