#pragma once

#include <optional>

#include "app/settings/settings.h"

namespace throng::app {

/// Two tunings to compare, A and B: one in use, the other kept until they change places. What is paused stays paused,
/// and how one looks at level of detail stays as it is.
class TuningPair {
 public:
  [[nodiscard]] bool shows_b() const { return shows_b_; }

  /// The other one comes into use; the first time it is the same.
  void change_places(Tuning& tuning);
  /// The other one becomes what is in use.
  void copy_to_other(const Tuning& tuning) { other_ = tuning; }

 private:
  std::optional<Tuning> other_;
  bool shows_b_ = false;
};

}  // namespace throng::app
