#include "app/window/unsaved_values.h"

#include <utility>

namespace throng::app {
namespace {

// Leaves out pauses and ways to look, which are not missed.
Tuning worth_keeping(Tuning tuning) {
  const Tuning standard;
  tuning.paused = standard.paused;
  tuning.inspection = standard.inspection;
  tuning.taken_away = standard.taken_away;
  tuning.debug_view = standard.debug_view;
  tuning.trail_seconds = standard.trail_seconds;
  tuning.bones_as_lines = standard.bones_as_lines;
  return tuning;
}

}  // namespace

void UnsavedValues::keep(const Tuning& tuning, const TuningPair& pair) {
  std::optional<Tuning> other;
  if (pair.has_two()) other = worth_keeping(pair.other());
  kept_other_ = other && is_kept(*other) ? other : std::nullopt;
  kept_ = worth_keeping(tuning);
  asked_about_.clear();
}

void UnsavedValues::keep_other(const Tuning& tuning) { kept_other_ = worth_keeping(tuning); }

bool UnsavedValues::ask_about(const Tuning& tuning, const TuningPair& pair) {
  std::vector<Tuning> unsaved{worth_keeping(tuning)};
  if (pair.has_two()) unsaved.push_back(worth_keeping(pair.other()));
  std::erase_if(unsaved, [this](const Tuning& each) { return is_kept(each); });
  if (unsaved.empty() || unsaved == asked_about_) return false;
  asked_about_ = std::move(unsaved);
  return true;
}

}  // namespace throng::app
