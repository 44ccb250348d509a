#include "app/window/frame_pace.h"

#include <gtest/gtest.h>

#include "app/settings/settings.h"

namespace throng::app::frame_pace_test {
namespace {

using namespace std::chrono_literals;

Tuning limited_to(int frames_a_second) {
  Tuning tuning;
  tuning.frame_limit = frames_a_second;
  return tuning;
}

TEST(FramePace, GivesEachFrameTheTimeThatTheLimitLeaves) {
  EXPECT_EQ(FramePace::least_time(limited_to(0)), 0ms);
  EXPECT_EQ(FramePace::least_time(limited_to(8)), 125ms);
}

TEST(FramePace, EndsNoFrameBeforeTheLimitAllowsTheNext) {
  FramePace pace;
  const auto began = FramePace::Clock::now();
  pace.end_frame(began, limited_to(50));
  EXPECT_GE(FramePace::Clock::now(), began + 20ms);
}

}  // namespace
}  // namespace throng::app::frame_pace_test
