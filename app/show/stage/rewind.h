#pragma once

#include <cstddef>
#include <deque>
#include <memory>

#include "app/show/stage/moment.h"

namespace throng::app {

class Stage;

/// A few snapshots of the crowd in the last seconds, to go back to.
class Rewind {
 public:
  static constexpr std::size_t most_moments = 10;
  static constexpr Ticks time_between = ticks_per_second / 2;
  static constexpr int most_agents = 20'000;  ///< snapshots of more agents would fill memory

  /// Remembers the frame if the last moment is long enough ago and no clip is held. Forgets the moments of another
  /// crowd. Call it after each frame.
  void watch(const Stage& stage);

  /// Takes the stage back to a moment, 0 the newest, and forgets it and all newer ones. Errors: there is no such moment
  /// of this crowd, or the schedule has changed since; then nothing has changed.
  Status go_back(Stage& stage, std::size_t moment = 0);

  /// Forgets all moments; call it when the crowd has started anew.
  void forget() { moments_.clear(); }

  std::size_t count() const { return moments_.size(); }
  /// Returns the time from a moment, 0 the newest, to the stage's clock; 0 if there is no such moment.
  Ticks age(const Stage& stage, std::size_t moment = 0) const;

 private:
  std::deque<std::unique_ptr<StageMoment>> moments_;  // oldest first
};

}  // namespace throng::app
