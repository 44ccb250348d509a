#pragma once

#include <cstddef>
#include <deque>
#include <memory>

#include "app/stage/moment.h"
#include "app/stage/stage.h"

namespace throng::app {

/// The crowd as it was: a few snapshots of the last seconds, to go back to.
class Rewind {
 public:
  static constexpr std::size_t most_moments = 10;
  static constexpr anim::Ticks time_between = anim::ticks_per_second / 2;
  static constexpr int most_agents = 20'000;  ///< of more, the snapshots would fill memory

  /// After each frame: remembers it if the last moment is long enough ago.
  void watch(const Stage& stage);

  /// Back to the newest moment, which is forgotten, so that the next time it is the one before it. Errors: there is
  /// none, or the schedule has changed since; then nothing has changed.
  anim::Status go_back(Stage& stage);

  /// After the crowd started anew.
  void forget() { moments_.clear(); }

  [[nodiscard]] std::size_t count() const { return moments_.size(); }
  /// From the newest moment to the stage's clock; 0 of none.
  [[nodiscard]] anim::Ticks age(const Stage& stage) const;

 private:
  std::deque<std::unique_ptr<StageMoment>> moments_;  // oldest first
};

}  // namespace throng::app
