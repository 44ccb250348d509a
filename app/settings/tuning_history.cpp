#include "app/settings/tuning_history.h"

#include <utility>

namespace throng::app {
namespace {

Tuning with_pause_of(Tuning tuning, const Tuning& other) {
  tuning.paused = other.paused;
  return tuning;
}

}  // namespace

void TuningHistory::take(const Tuning& tuning) {
  settled_ = tuning;
  begun_ = true;
}

void TuningHistory::watch(const Tuning& tuning, bool is_busy) {
  if (!begun_) take(tuning);
  if (is_busy || with_pause_of(settled_, tuning) == tuning) return;
  before_.push_back(std::exchange(settled_, tuning));
  after_.clear();
  if (before_.size() > most_steps) before_.pop_front();
}

bool TuningHistory::undo(Tuning& tuning) { return step(before_, after_, tuning); }

bool TuningHistory::redo(Tuning& tuning) { return step(after_, before_, tuning); }

bool TuningHistory::step(std::deque<Tuning>& from, std::deque<Tuning>& to, Tuning& tuning) {
  if (from.empty()) return false;
  to.push_back(tuning);
  tuning = with_pause_of(std::move(from.back()), tuning);
  from.pop_back();
  settled_ = tuning;
  return true;
}

}  // namespace throng::app
