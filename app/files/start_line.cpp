#include "app/files/start_line.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/files/progress_line.h"

namespace throng::app {
namespace {

constexpr std::chrono::milliseconds not_long(500), pause(100);

}  // namespace

std::string bar_text(double share, const std::string& what) {
  constexpr long width = 20;
  const auto done = static_cast<std::size_t>(std::clamp(std::lround(share * width), 0L, width));
  return "[" + std::string(done, '=') + std::string(width - done, ' ') + "] " + what;
}

// A thread shows the line, because the work may take long from one show() to the next.
StartLine::StartLine() {
  if (!shows_progress()) return;
  try {
    shows_ = std::thread([this] { show(); });
  } catch (const std::system_error&) {  // no more threads: the start goes on without a line
  }
}

StartLine::~StartLine() {
  if (!shows_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  shows_.join();
}

void StartLine::show(double share, std::string what) {
  const std::scoped_lock lock(mutex_);
  share_ = share;
  what_ = std::move(what);
  if (what_.empty() && is_shown_) show_progress("");
  is_shown_ = is_shown_ && !what_.empty();
}

void StartLine::show() {
  std::unique_lock lock(mutex_);
  for (auto wait = not_long; !ended_.wait_for(lock, wait, [this] { return has_ended_; }); wait = pause) {
    if (what_.empty()) continue;
    show_progress(bar_text(share_, what_));
    is_shown_ = true;
  }
  if (is_shown_) show_progress("");
}

}  // namespace throng::app
