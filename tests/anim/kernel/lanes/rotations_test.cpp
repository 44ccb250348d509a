#include "engine/anim/kernel/lanes/rotations.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/kernel/lanes/smooth_damp.h"
#include "tests/anim/kernel/pose/held_pose.h"

namespace throng::anim::rotations_test {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr glm::vec3 up{0.0F, 1.0F, 0.0F};

TEST(Rotations, TurnAboutAnAxisAsTheSineSays) {
  for (int step = -100; step <= 100; ++step) {
    const float angle = pi * static_cast<float>(step) / 100.0F;
    const glm::quat turn = turn_about(up, angle);
    EXPECT_NEAR(turn.y, std::sin(angle / 2.0F), 2e-7F);
    EXPECT_NEAR(turn.w, std::cos(angle / 2.0F), 2e-7F);
  }
}

TEST(Rotations, KnowTheAngleOfEveryPoint) {
  for (int step = -99; step <= 99; ++step) {
    const float angle = pi * static_cast<float>(step) / 100.0F;
    EXPECT_NEAR(angle_of(3.0F * std::sin(angle), 3.0F * std::cos(angle)), angle, 6e-7F);
  }
  EXPECT_NEAR(angle_of(0.0F, -2.0F), pi, 6e-7F);
  EXPECT_EQ(angle_of(0.0F, 0.0F), 0.0F);
}

TEST(Rotations, BringAnyDirectionToAnyOther) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 from = random_direction(random);
    const glm::vec3 to = i % 3 == 0 ? -from : i % 3 == 1 ? from : random_direction(random);
    EXPECT_LT(glm::distance(shortest_turn(from, to) * from, to), 1e-6F);
  }
}

TEST(Rotations, StopAtALimit) {
  const glm::vec3 aside(1.0F, 0.0F, 0.0F);
  const glm::vec3 turned = limited_turn(up, aside, std::cos(0.3F)) * up;
  EXPECT_NEAR(std::acos(glm::dot(turned, up)), 0.3F, 1e-5F);
  EXPECT_GT(turned.x, 0.0F);
}

TEST(Rotations, HaveADirectionForWhatHasNone) {
  EXPECT_EQ(unit_or(glm::vec3(0.0F), up), up);
  EXPECT_EQ(unit_or(glm::vec3(std::numeric_limits<float>::quiet_NaN()), up), up);
  EXPECT_LT(glm::distance(unit_or({0.0F, 1e30F, 0.0F}, {1.0F, 0.0F, 0.0F}), up), 1e-6F);
}

TEST(SmoothDamp, FollowsWithoutOvershootingWhateverTheStep) {
  for (const float seconds : {0.001F, 0.016F, 0.1F, 5.0F}) {
    DampedValue follower;
    float last = 0.0F;
    for (float time = 0.0F; time < 10.0F; time += seconds) {
      follower = smooth_damp(follower, 1.0F, 0.2F, seconds);
      EXPECT_GE(follower.value, last);
      EXPECT_LE(follower.value, 1.0F);
      last = follower.value;
    }
    EXPECT_NEAR(last, 1.0F, 1e-4F) << seconds;
  }
}

TEST(SmoothDamp, IsMostOfTheWayAfterTwiceItsTime) {
  DampedValue follower;
  for (int step = 0; step < 400; ++step) follower = smooth_damp(follower, 1.0F, 0.2F, 0.001F);
  EXPECT_NEAR(follower.value, 0.908F, 0.005F);  // 1 - (1 + 4) * exp(-4)
}

TEST(SmoothDamp, IsThereAtOnceWithoutSmoothing) { EXPECT_EQ(smooth_damp({0.0F, 3.0F}, 1.0F, 0.0F, 0.01F).value, 1.0F); }

}  // namespace
}  // namespace throng::anim::rotations_test
