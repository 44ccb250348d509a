// A window that gives up parts of the picture to hold its frame rate.

#include "app/window/frame_rate_keeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::frame_rate_keeper_test {
namespace {

using testing::HasSubstr;

constexpr double in_time = 1000.0 / 30.0;

Tuning holding() {
  Tuning tuning;
  tuning.holds_rate = true;
  tuning.frame_rate = 30.0F;
  return tuning;
}

/// A device whose frames take as long as the picture has triangles and pixels.
struct Device {
  double milliseconds_at_best = 200.0;

  double frame(const Tuning& tuning) const {
    const double size = tuning.picture_size / 100.0;
    const double triangles = tuning.triangle_budget == 0 ? 1.0 : tuning.triangle_budget / 600'000.0;
    return milliseconds_at_best * (0.1 + 0.4 * size * size + 0.3 * triangles + (tuning.shadows ? 0.2 : 0.0));
  }
};

/// Shows frames for some seconds, and returns how often the cost changed.
int show(FrameRateKeeper& keeper, const Device& device, const Tuning& asked, double seconds) {
  int changes = 0;
  for (double passed = 0.0; passed < seconds;) {
    const Tuning shown = keeper.kept(asked);
    const double frame = device.frame(shown);
    keeper.add_frame(frame, asked);
    passed += std::max(frame, in_time) / 1000.0;
    changes += cost_of(keeper.kept(asked)) == cost_of(shown) ? 0 : 1;
  }
  return changes;
}

TEST(FrameRateKeeper, ComesToTheRateInFiveSeconds) {
  FrameRateKeeper keeper;
  const Device device;
  show(keeper, device, holding(), 5.0);
  EXPECT_LT(device.frame(keeper.kept(holding())), 1.06 * in_time);
  EXPECT_GT(keeper.kept(holding()).picture_size, 25) << "it gives up no more than it must";
}

TEST(FrameRateKeeper, GoesUpAgainWhereThereIsTime) {
  FrameRateKeeper keeper({}, true);
  show(keeper, {.milliseconds_at_best = 15.0}, holding(), 40.0);
  EXPECT_EQ(cost_of(keeper.kept(holding())), PictureCost{});
  EXPECT_EQ(keeper.given_up(holding()), "");
}

TEST(FrameRateKeeper, DoesNotFlickerAboutALimit) {
  FrameRateKeeper keeper;
  const Device device{.milliseconds_at_best = 90.0};
  show(keeper, device, holding(), 10.0);
  EXPECT_LE(show(keeper, device, holding(), 60.0), 4);
}

TEST(FrameRateKeeper, TakesASingleSlowFrameForWhatItIs) {
  FrameRateKeeper keeper;
  for (int frame = 0; frame < 100; ++frame) keeper.add_frame(frame % 10 == 0 ? 200.0 : 25.0, holding());
  EXPECT_EQ(cost_of(keeper.kept(holding())), PictureCost{});
}

TEST(FrameRateKeeper, LeavesWhatAPersonSetsByHand) {
  FrameRateKeeper keeper;
  const Tuning asked = holding();
  show(keeper, {}, asked, 5.0);
  Tuning by_person = keeper.kept(asked);
  ASSERT_FALSE(by_person.shadows);
  by_person.shadows = true;
  by_person.agents = 17;
  const Tuning now = keeper.changed(by_person, asked);
  EXPECT_EQ(now.agents, 17);
  EXPECT_TRUE(keeper.kept(now).shadows);
  EXPECT_LT(keeper.kept(now).picture_size, 100) << "the other values go on";
  EXPECT_EQ(now.picture_size, 100) << "what was given up is not asked for";
  Tuning off = keeper.kept(now), on = off;
  off.holds_rate = false;
  on.shadows = false;
  const Tuning anew = keeper.changed(on, keeper.changed(off, now));
  EXPECT_FALSE(keeper.kept(anew).shadows) << "the rate that is asked for anew decides over all";
}

TEST(FrameRateKeeper, SaysInALineWhatItGivesUp) {
  FrameRateKeeper keeper;
  show(keeper, {}, holding(), 5.0);
  EXPECT_THAT(keeper.given_up(holding()), HasSubstr("To show 30 frames a second: the picture has "));
  EXPECT_THAT(keeper.given_up(holding()), HasSubstr("no shadows"));
  FrameRateKeeper with_shadows({.shadows = true});
  show(with_shadows, {}, holding(), 5.0);
  EXPECT_THAT(with_shadows.given_up(holding()), testing::Not(HasSubstr("shadows")));
}

TEST(FrameRateKeeper, HoldsNothingUnlessAskedAndSaysThatItHelps) {
  FrameRateKeeper keeper({}, true);
  const Tuning asked;
  EXPECT_EQ(keeper.advice(asked), "");
  show(keeper, {}, asked, 5.0);
  EXPECT_EQ(keeper.kept(asked), asked);
  EXPECT_EQ(keeper.advice(asked),
            "No graphics card: the processor draws. A frame takes 200 ms; quality auto shows up to 30 a second.");
  EXPECT_EQ(keeper.advice(holding()), "");
}

TEST(FrameRateKeeper, AdvisesNothingWhereFramesAreFast) {
  FrameRateKeeper keeper;
  show(keeper, {.milliseconds_at_best = 20.0}, Tuning(), 5.0);
  EXPECT_EQ(keeper.advice(Tuning()), "");
}

TEST(BestPicture, HasAllThatAWindowGaveUpAndWhatThePersonSetByHand) {
  FrameRateKeeper keeper({.shadows = true});
  show(keeper, {}, holding(), 5.0);
  Tuning asked = holding();
  asked.shadows = false;
  asked.picture_size = 50;
  const Tuning best = keeper.at_best(asked);
  EXPECT_EQ(best.picture_size, 100) << "the size holds the rate, also by hand";
  EXPECT_EQ(best.triangle_budget, 0);
  EXPECT_TRUE(best.crowd_shade);
  EXPECT_FALSE(best.shadows) << "set by hand";
  EXPECT_FALSE(best.holds_rate);
}

TEST(BestPicture, OfALowQualityIsThatOfAHighOne) {
  Tuning low;
  take_quality("low", low);
  EXPECT_EQ(cost_of(FrameRateKeeper().at_best(low)), picture_costs.front());
  low.triangle_budget = 1234;
  EXPECT_EQ(FrameRateKeeper().at_best(low).triangle_budget, 1234) << "no quality has that, so it was set by hand";
}

TEST(FrameLimit, GivesEachFrameTheTimeThatTheLimitLeaves) {
  using namespace std::chrono_literals;
  EXPECT_EQ(least_frame_time({.frame_limit = 8}), 125ms);
  EXPECT_EQ(least_frame_time({}), 0ms) << "no limit";
}

}  // namespace
}  // namespace throng::app::frame_rate_keeper_test
