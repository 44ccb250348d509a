#include "app/window/slow_frames.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace throng::app::slow_frames_test {
namespace {

void pass(SlowFrames& frames, int number, float milliseconds) {
  frames.add(number, milliseconds, [&]() -> FrameDetails {
    return {.frame_ms = milliseconds, .update_ms = 1, .work = {}, .pu = {}, .timeline = {.frame = number, .time = {}}};
  });
}

bool keeps(const SlowFrames& frames, int number) { return std::ranges::binary_search(frames.report().numbers, number); }

TEST(SlowFrames, KeepTheSlowestOfTheLastFramesAndNoMoreThanTheySay) {
  SlowFrames frames;
  for (int number = 1; number <= 200; ++number) pass(frames, number, number % 10 == 0 ? 50.0F : 10.0F);
  EXPECT_EQ(frames.report().numbers.size(), SlowFrames::most_frames);
  EXPECT_TRUE(std::ranges::is_sorted(frames.report().numbers));
  EXPECT_TRUE(keeps(frames, 200));
  EXPECT_TRUE(keeps(frames, 60));
  EXPECT_FALSE(keeps(frames, 199));
}

TEST(SlowFrames, ForgetASpikeThatIsTooLongAgo) {
  SlowFrames frames;
  pass(frames, 1, 500.0F);
  for (int number = 2; number <= SlowFrames::frames_back; ++number) pass(frames, number, 10.0F);
  EXPECT_TRUE(keeps(frames, 1));
  pass(frames, SlowFrames::frames_back + 1, 10.0F);
  EXPECT_FALSE(keeps(frames, 1));
}

TEST(SlowFrames, HoldWhatIsLookedAtUntilOneLooksElsewhere) {
  SlowFrames frames;
  frames.look_at(3);
  EXPECT_FALSE(frames.report().looked_at) << "there is none yet";
  for (int number = 1; number <= 100; ++number)
    pass(frames, number, number == 40 ? 500.0F : 10.0F + 0.01F * static_cast<float>(number % 7));
  frames.look_at(39);
  ASSERT_TRUE(frames.report().looked_at);
  EXPECT_EQ(frames.report().looked_at->number(), 40) << "nearest to the click";
  for (int number = 101; number <= 600; ++number) pass(frames, number, 10.0F);
  ASSERT_TRUE(frames.report().looked_at);
  EXPECT_EQ(frames.report().looked_at->number(), 40);
  EXPECT_EQ(frames.report().looked_at->frame_ms, 500.0F);
  frames.look_at_last();
  EXPECT_FALSE(frames.report().looked_at);
}

TEST(SlowFrames, DescribeOnlyFramesThatAreKept) {
  SlowFrames frames;
  for (int number = 1; number <= 16; ++number) pass(frames, number, 20.0F);
  int described = 0;
  frames.add(17, 10.0F, [&]() -> FrameDetails {
    ++described;
    return {};
  });
  EXPECT_EQ(described, 0);
}

}  // namespace
}  // namespace throng::app::slow_frames_test
