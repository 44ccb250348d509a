#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// A looping clip and the moments that mark its way, such as the strikes of its feet.
struct MarkedClip {
  std::span<const DataKey> keys;  ///< ascending
  Ticks duration{};               ///< above 0
};

/// Maps the positions of one looping clip, the leader, to positions of another, so that the markers of both come at the
/// same time. Between two markers the map is linear. Markers are the data keys whose names both clips have. Where their
/// names do not follow each other in the same order, where two fall on one moment, or where there are none or more
/// than `most_markers`, the map goes by the phase of the loop alone. It allocates nothing.
class MarkerMap {
 public:
  static constexpr std::size_t most_markers = 16;

  MarkerMap(const MarkedClip& leader, const MarkedClip& follower);

  bool has_markers() const { return has_markers_; }

  /// The way from one marker to the next, where the map is linear. A caller keeps it for as long as holds() says.
  struct Way {
    FineTicks begin = 0;   ///< of the leader, unwrapped
    FineTicks end = 0;     ///< above `begin`; as far away at most as the leader is long
    double rate = 1.0;     ///< of the follower, in its own time for each unit of the leader's
    FineTicks from = 0;    ///< of the follower, where the leader is at `begin`
    FineTicks length = 0;  ///< of the follower's way
    FineTicks loop = 1;    ///< of the follower
    bool has_markers = false;

    /// `leader` is a position from 0 to below the leader's duration.
    bool holds(FineTicks leader) const { return begin <= leader && leader < end; }
    /// Returns the position of the follower, 0 to below its duration, where this way holds the leader.
    FineTicks position(FineTicks leader) const;
  };
  /// Returns the way that holds a position of the leader, from 0 to below its duration.
  Way way(FineTicks leader) const;

 private:
  FineTicks leader_length_;
  FineTicks follower_length_;
  std::array<FineTicks, most_markers> leader_{};    // [marker] ascending
  std::array<FineTicks, most_markers> follower_{};  // [marker] ascending, but for one seam
  std::size_t count_ = 1;
  bool has_markers_ = false;
};

}  // namespace throng::anim
