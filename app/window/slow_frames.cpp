#include "app/window/slow_frames.h"

#include <algorithm>
#include <cstdlib>

namespace throng::app {

void SlowFrames::add(int number, float frame_ms, const std::function<FrameDetails()>& describe) {
  const auto now = Clock::now();
  const int oldest = number - frames_back;
  std::erase_if(kept_, [oldest](const Kept& each) { return each.details.number() <= oldest; });
  const auto time_of = [](const Kept& each) { return each.details.frame_ms; };
  if (kept_.size() == most_frames) {
    const auto fastest = std::ranges::min_element(kept_, {}, time_of);
    if (time_of(*fastest) <= frame_ms) kept_.erase(fastest);
  }
  if (kept_.size() < most_frames) kept_.push_back({describe(), now});
  list_numbers();
  if (report_.looked_at) report_.seconds_ago = std::chrono::duration<float>(now - looked_at_ended_).count();
}

void SlowFrames::look_at(int number) {
  const auto distance = [number](const Kept& each) { return std::abs(each.details.number() - number); };
  const auto nearest = std::ranges::min_element(kept_, {}, distance);
  if (nearest == kept_.end()) return;
  report_.looked_at = nearest->details;
  looked_at_ended_ = nearest->ended;
  report_.seconds_ago = std::chrono::duration<float>(Clock::now() - nearest->ended).count();
}

void SlowFrames::list_numbers() {
  report_.numbers.clear();
  for (const Kept& each : kept_) report_.numbers.push_back(each.details.number());
}

}  // namespace throng::app
