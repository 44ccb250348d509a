#include "app/files/progress_bar.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

#include "app/files/progress_line.h"

namespace throng::app {
namespace {

constexpr std::chrono::milliseconds pause(100);

}  // namespace

std::string bar_text(double share, const std::string& what) {
  if (share < 0) return what;
  constexpr long width = 20;
  const auto done = static_cast<std::size_t>(std::clamp(std::lround(share * width), 0L, width));
  return "[" + std::string(done, '=') + std::string(width - done, ' ') + "] " + what;
}

// A thread shows the bar, because the work may take long from one show() to the next.
ProgressBar::ProgressBar(std::chrono::milliseconds not_long) {
  if (!shows_progress()) return;
  try {
    shows_ = std::thread([this, not_long] { show_after(not_long); });
  } catch (const std::system_error&) {  // no more threads: the work goes on without a bar
  }
}

ProgressBar::~ProgressBar() {
  if (!shows_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_one();
  shows_.join();
}

void ProgressBar::show(double share, std::string what) {
  const std::scoped_lock lock(mutex_);
  share_ = share;
  what_ = std::move(what);
  if (what_.empty() && is_shown_) show_progress("");
  is_shown_ = is_shown_ && !what_.empty();
}

void ProgressBar::show_after(std::chrono::milliseconds not_long) {
  std::unique_lock lock(mutex_);
  for (auto wait = not_long; !ended_.wait_for(lock, wait, [this] { return has_ended_; }); wait = pause) {
    if (what_.empty()) continue;
    show_progress(bar_text(share_, what_));
    is_shown_ = true;
  }
  if (is_shown_) show_progress("");
}

}  // namespace throng::app
