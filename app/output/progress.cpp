#include "app/output/progress.h"

#include <cmath>
#include <cstdio>

#include "engine/base/text/joined.h"

namespace throng::app {

std::string time_text(double seconds) {
  constexpr double exact = 10;
  if (seconds < exact) return fixed(seconds, 1) + " s";
  const auto whole = static_cast<long long>(std::llround(seconds));
  constexpr long long minute = 60, hour = 3600;
  if (whole < minute) return std::to_string(whole) + " s";
  if (whole < hour) return std::to_string(whole / minute) + " min " + std::to_string(whole % minute) + " s";
  return std::to_string(whole / hour) + " h " + std::to_string(whole % hour / minute) + " min";
}

std::string progress_text(int frame, int frames, double seconds) {
  const double rate = seconds > 0 ? frame / seconds : 0;
  std::string text = "frame " + std::to_string(frame);
  if (frames > 0) text += " of " + std::to_string(frames);
  text += ", " + fixed(rate, rate < 10 ? 1 : 0) + " a second";
  if (frames > 0 && rate > 0) text += ", " + time_text((frames - frame) / rate) + " left";
  return text;
}

void Progress::show(int frame) {
  frame_ = frame;
  constexpr double pause = 0.1;
  if (says_lines_ && (frame == 1 || frame == frames_ || seconds() > said_at_ + pause)) {
    said_at_ = seconds();
    std::fprintf(stderr, "%s\n", progress_text(frame, frames_, said_at_).c_str());
  }
  if (!bar_.is_there()) return;
  bar_.show(frames_ > 0 ? static_cast<double>(frame) / frames_ : -1, progress_text(frame, frames_, seconds()));
}

}  // namespace throng::app
