#include "app/window/unsaved_work.h"

namespace throng::app {
namespace {

// Leaves out pauses, ways to look and the pace of the window, which are not missed.
Tuning worth_keeping(Tuning tuning) {
  const Tuning standard;
  tuning.paused = standard.paused;
  tuning.inspection = standard.inspection;
  tuning.taken_away = standard.taken_away;
  tuning.debug_view = standard.debug_view;
  tuning.trail_seconds = standard.trail_seconds;
  tuning.plain_bodies = standard.plain_bodies;
  tuning.ids = standard.ids;
  tuning.bones_as_lines = standard.bones_as_lines;
  tuning.frame_limit = standard.frame_limit;
  tuning.vertical_sync = standard.vertical_sync;
  return tuning;
}

bool is_another_time(const TrackClock& now, TrackClock kept, bool stands_still) {
  if (!stands_still) kept.seconds = now.seconds;
  kept.stands = now.stands;
  return now != kept;
}

}  // namespace

void UnsavedWork::keep(const Tuning& tuning, const TuningPair& pair) {
  std::optional<Tuning> other;
  if (pair.has_two()) other = worth_keeping(pair.other());
  kept_other_ = other && is_kept(*other) ? other : std::nullopt;
  kept_ = worth_keeping(tuning);
}

void UnsavedWork::keep_other(const Tuning& tuning) { kept_other_ = worth_keeping(tuning); }

std::vector<std::string> UnsavedWork::parts(const Tuning& tuning, const TuningPair& pair, const CrowdWork& work) const {
  std::vector<std::string> parts;
  const bool other_is_kept = !pair.has_two() || is_kept(worth_keeping(pair.other()));
  if (!is_kept(worth_keeping(tuning)) || !other_is_kept) parts.emplace_back("the values");
  if (work.characters != kept_work_.characters) parts.emplace_back("the choices for the characters");
  if (work.places != kept_work_.places) parts.emplace_back("the places of the camera");
  if (!work.recorded) return parts;
  const RecordedView& now = *work.recorded;
  const RecordedView kept = kept_work_.recorded.value_or(now);
  if (is_another_time(now.clock, kept.clock, tuning.paused)) parts.emplace_back("the time of the recorded crowd");
  if (now.camera && now.camera != kept.camera) parts.emplace_back("its camera");
  return parts;
}

}  // namespace throng::app
