#include "app/window/frame_pace.h"

#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/settings/settings.h"

namespace throng::app {

FramePace::Clock::duration FramePace::least_time(const Tuning& tuning) {
  return tuning.frame_limit > 0 ? Clock::duration(std::chrono::seconds(1)) / tuning.frame_limit : Clock::duration();
}

void FramePace::end_frame(Clock::time_point began, const Tuning& tuning) {
  if (tuning.vertical_sync != follows_display_) {
    follows_display_ = tuning.vertical_sync;
    glfwSwapInterval(follows_display_ ? 1 : 0);
  }
  std::this_thread::sleep_until(began + least_time(tuning));
}

}  // namespace throng::app
