#pragma once

#include "app/crowd/layout.h"

namespace throng::app {

/// Lays out companies in rank and file on a closed route of two straights and two ends, and spectators along it. The
/// distance between files is such that on every quarter turn a file walks one whole cycle of the walk clip (or two,
/// ...) more than the file inside it: on the straights all marchers are in step, and no feet slide.
CrowdLayout parade_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

/// Returns the place of a marcher after `seconds`.
LanePlace marcher_place(const Lane& route, const MarcherStart& marcher, double seconds);

/// Returns the phase of the walk clip, 0 to below 1, that a marcher starts with, so that all of its file and rank are
/// in step.
double marcher_phase(const Lane& route, const MarcherStart& marcher, const CharacterRoles& roles);

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
