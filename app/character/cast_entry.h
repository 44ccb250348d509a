#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// The most characters of people in one crowd. A system animates 32; the balloon and the camera of the film are two.
inline constexpr std::size_t most_models = 30;

/// The range of a share. A share may be a number of agents as well as a part.
inline constexpr double least_share = 0.01, most_share = 10'000;
/// Returns whether it can be the share of one character, which may be part of a folder's share.
constexpr bool is_share(double share) { return share > 0.0 && share <= most_share; }

/// An entry of a cast: "FILE", "FILE#SKIN", or a folder of such files.
struct CastEntry {
  std::string file;
  /// The share of the entry as a whole, split evenly among its characters; none: 1 for each of them.
  std::optional<double> share = {};
  /// The files whose clips its characters play too, in place of all others.
  std::optional<std::vector<std::string>> clip_files = {};
  /// The size and place of its characters, in place of all others.
  std::optional<anim::PlacementChoice> placement = {};

  friend bool operator==(const CastEntry&, const CastEntry&) = default;
};

}  // namespace throng::app
