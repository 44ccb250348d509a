#include "app/window/window_replay.h"

#include <algorithm>
#include <chrono>

#include "app/show/replay.h"
#include "app/show/show.h"

namespace throng::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds longest_wait{60};
constexpr double paused_frame = 1.0 / 60.0;  // seconds that a frame is seen in which no time passed

}  // namespace

WindowReplay::WindowReplay(Replay& replay) : replay_(replay) {
  replay.allow_to_go_back();
  report_.frames = replay.count_frames();
}

void WindowReplay::take(const ReplayRequest& request) {
  std::visit([this](const auto& asked) { carry_out(asked); }, request);
}

void WindowReplay::carry_out(const ToggleReplayPause& /*asked*/) {
  if (!report_.ended) {
    report_.paused = !report_.paused;
    return;
  }
  report_.sought = 1;
  report_.paused = false;
}

void WindowReplay::carry_out(const StepReplay& asked) {
  const auto from = static_cast<std::int64_t>(report_.sought.value_or(report_.frame));
  go_to(from + asked.frames);
  report_.paused = true;
}

void WindowReplay::go_to(std::int64_t frame) {
  const auto last = std::max<std::int64_t>(static_cast<std::int64_t>(report_.frames), 1);
  report_.sought = static_cast<std::uint64_t>(std::clamp<std::int64_t>(frame, 1, last));
}

void WindowReplay::advance(Show& show, double seconds) {
  if (report_.sought) return seek(show);
  if (replay_.frame() == 0 && !report_.ended) return step(show);
  if (!report_.paused) play(show, seconds);
}

void WindowReplay::play(Show& show, double seconds) {
  if (report_.ended && report_.loops && !report_.differs) begin_anew(show);
  due_ += seconds * static_cast<double>(report_.speed);
  for (const Clock::time_point end = Clock::now() + longest_wait; due_ > 0 && !report_.ended;) {
    step(show);
    due_ -= replay_.delta() == Ticks{} ? paused_frame : to_seconds(replay_.delta());
    if (Clock::now() > end) due_ = std::min(due_, 0.0);  // frames that this machine cannot show in time, it shows later
  }
}

void WindowReplay::seek(Show& show) {
  const std::uint64_t sought = *report_.sought;
  if (sought < replay_.frame()) begin_anew(show);
  for (const Clock::time_point end = Clock::now() + longest_wait;
       replay_.frame() < sought && !report_.ended && Clock::now() < end;) {
    step(show);
  }
  if (replay_.frame() < sought && !report_.ended) return;
  report_.sought.reset();
  due_ = 0;
}

void WindowReplay::step(Show& show) {
  const Result<bool> repeated = replay_.step(show);
  report_.frame = replay_.frame();
  if (!repeated) return end_with(repeated.error());
  if (!*repeated) return end_with(Done{});
  // The end is looked at with the last frame, so that it is said at once.
  if (report_.frame < report_.frames) return;
  const Result<bool> ended = replay_.step(show);
  end_with(ended ? Status(Done{}) : Status(ended.error()));
}

void WindowReplay::begin_anew(Show& show) {
  report_.ended = report_.differs = false;
  report_.outcome.clear();
  if (const Status begun = replay_.begin_anew(show); !begun) end_with(begun);
  report_.frame = replay_.frame();
}

void WindowReplay::end_with(const Status& outcome) {
  report_.ended = true;
  report_.differs = !outcome;
  report_.outcome = outcome ? replay_.summary() : outcome.error().message;
  if (outcome_) outcome_ = outcome;
}

}  // namespace throng::app
