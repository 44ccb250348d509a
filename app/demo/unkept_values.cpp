#include "app/demo/unkept_values.h"

namespace throng::app {
namespace {

// Nobody misses a pause, nor a way to look.
Tuning worth_keeping(Tuning tuning) {
  const Tuning standard;
  tuning.paused = standard.paused;
  tuning.inspection = standard.inspection;
  tuning.taken_away = standard.taken_away;
  tuning.debug_view = standard.debug_view;
  tuning.bones_as_lines = standard.bones_as_lines;
  return tuning;
}

}  // namespace

void UnkeptValues::keep(const Tuning& tuning) {
  kept_ = worth_keeping(tuning);
  asked_about_.reset();
}

bool UnkeptValues::ask_about(const Tuning& tuning) {
  const Tuning now = worth_keeping(tuning);
  if (now == kept_ || now == asked_about_) return false;
  asked_about_ = now;
  return true;
}

}  // namespace throng::app
