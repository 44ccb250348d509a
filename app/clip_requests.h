#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "app/crowd.h"

namespace throng::app {

/// Clip requests that an agent's blend tree had no room for, kept until it has; of each agent the last one.
class ClipRequests {
 public:
  /// Forgets everything, and sets aside memory for `agents`, so that later frames allocate nothing.
  void reset(std::size_t agents) {
    waiting_.clear();
    waiting_.reserve(agents);
  }

  /// Asks for those that wait, then for the new ones, at most one an agent, each of which replaces what its agent waits
  /// for. `play(request)` is false while there is no room.
  template <typename Play>
  void submit(std::span<const ClipRequest> requests, const Play& play) {
    std::erase_if(waiting_, [&](const ClipRequest& waiting) {
      const bool is_replaced = std::ranges::find(requests, waiting.agent, &ClipRequest::agent) != requests.end();
      return is_replaced || play(waiting);
    });
    for (const ClipRequest& request : requests) {
      if (!play(request)) waiting_.push_back(request);
    }
  }

  std::size_t waiting() const { return waiting_.size(); }

 private:
  std::vector<ClipRequest> waiting_;  // in the order of asking
};

}  // namespace throng::app
