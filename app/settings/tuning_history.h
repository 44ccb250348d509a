#pragma once

#include <cstddef>
#include <deque>

#include "app/settings/settings.h"

namespace throng::app {

/// The values that a person changed, to be taken back and made again. A change that is being made, such as a drag, is
/// one step once it is over. The pause is no part of it.
class TuningHistory {
 public:
  static constexpr std::size_t most_steps = 100;

  /// Watches the values once a frame. `is_busy`: a person is in the middle of a change.
  void watch(const Tuning& tuning, bool is_busy);
  /// Takes other values without a step, such as those of the other of two tunings.
  void take(const Tuning& tuning);

  /// Brings back the values before the last step. Returns whether there was one.
  bool undo(Tuning& tuning);
  /// Makes the last step that was taken back again. Returns whether there was one.
  bool redo(Tuning& tuning);

  [[nodiscard]] bool can_undo() const { return !before_.empty(); }
  [[nodiscard]] bool can_redo() const { return !after_.empty(); }

 private:
  bool step(std::deque<Tuning>& from, std::deque<Tuning>& to, Tuning& tuning);

  bool begun_ = false;
  Tuning settled_;  // the values after the last step
  std::deque<Tuning> before_, after_;
};

}  // namespace throng::app
