#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// How palettes are stored fastest: a matter of how many bytes they are, of the caches, and of whose memory it is. So
/// it is measured where it matters: the first updates of a crowd try the policies, each some times in a row because it
/// finds the caches as the last update left them, and the fastest is kept until the crowd has doubled or halved.
/// Streaming is not tried: whoever touches the lines next pays for it, which the update that is timed does not see.
/// Poses do not depend on it.
class StoreChoice {
 public:
  static constexpr int policies = 2;              ///< plain, prefetched
  static constexpr std::size_t least_crowd = 32;  ///< agents; the palettes of fewer fit any cache
  static constexpr int trials = 4;  ///< of each policy; the first of a crowd finds cold caches, so the best one counts

  /// For an update of so many agents.
  StorePolicy policy_for(std::size_t agents) {
    if (agents < least_crowd) return StorePolicy::plain;
    if (agents > 2 * crowd_ || 2 * agents < crowd_) {
      crowd_ = agents;
      done_ = 0;
      best_.fill(std::numeric_limits<double>::max());
    }
    return done_ < trials * policies ? static_cast<StorePolicy>(done_ / trials) : fastest();
  }

  /// How long that update took.
  void note(std::size_t agents, double milliseconds) {
    if (done_ == trials * policies || agents < least_crowd) return;
    double& best = best_[static_cast<std::size_t>(done_ / trials)];
    best = std::min(best, milliseconds / static_cast<double>(agents));
    ++done_;
  }

 private:
  StorePolicy fastest() const {
    return static_cast<StorePolicy>(std::min_element(best_.begin(), best_.end()) - best_.begin());
  }

  std::size_t crowd_ = 0;  // when it was measured
  int done_ = 0;
  std::array<double, policies> best_{};  // milliseconds an agent
};

}  // namespace throng::anim
