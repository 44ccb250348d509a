#pragma once

#include <optional>
#include <vector>

#include "app/settings/settings.h"
#include "app/settings/tuning_pair.h"

namespace throng::app {

/// Asks once before a window closes whose values are in no preset.
class UnsavedValues {
 public:
  /// Takes the values that a person began with, kept as a preset, or took from one.
  explicit UnsavedValues(const Tuning& begun_with) { keep(begun_with); }
  /// `pair` has the values to compare them with. Values that wait there stay kept if they were kept.
  void keep(const Tuning& tuning, const TuningPair& pair = {});
  /// Takes the values that wait, kept as a preset or taken from one.
  void keep_other(const Tuning& tuning);

  /// Returns whether to ask the person before these values, and the values that wait beside them, are left. Asks about
  /// equal values once.
  bool ask_about(const Tuning& tuning, const TuningPair& pair = {});

 private:
  bool is_kept(const Tuning& worth_keeping) const { return worth_keeping == kept_ || worth_keeping == kept_other_; }

  Tuning kept_;
  std::optional<Tuning> kept_other_;
  std::vector<Tuning> asked_about_;
};

}  // namespace throng::app
