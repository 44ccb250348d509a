#pragma once

#include <optional>

#include "app/settings/settings.h"

namespace throng::app {

/// Asks once before a window closes whose values are in no preset.
class UnkeptValues {
 public:
  /// Takes the values that a person began with, kept as a preset, or took from one.
  explicit UnkeptValues(const Tuning& begun_with) { keep(begun_with); }
  void keep(const Tuning& tuning);

  /// Returns whether the person is to be asked before these values are left. The same values are asked about once.
  bool ask_about(const Tuning& tuning);

 private:
  Tuning kept_;
  std::optional<Tuning> asked_about_;
};

}  // namespace throng::app
