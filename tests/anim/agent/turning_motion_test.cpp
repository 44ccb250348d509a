// How an agent moves whose clips turn.

#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "tests/anim/agent/gait_crowd.h"

namespace throng::anim::turning_motion_test {
namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

double apart(const RootMotion& a, const RootMotion& b) {
  return glm::distance(a.translation, b.translation) + std::abs(a.yaw - b.yaw);
}

RootMotion motion(const GaitCrowd& crowd, Ticks from, Ticks to) {
  return std::as_const(*crowd.system).agent(0).motion().displacement(from, to);
}

TEST(TurningMotion, OfFourSecondsOfAQuarterEachIsARound) {
  GaitCrowd crowd;
  crowd->agent(0).play({.clip = gaits::bend});
  const RootMotion round = motion(crowd, Ticks{}, 4 * ticks_per_second);
  EXPECT_NEAR(round.yaw, 4.0 * quarter, 1e-6);
  EXPECT_LT(glm::length(round.translation), 1e-6);
}

/// Plays a walk straight ahead and a bend, half of each.
GaitCrowd blended() {
  GaitCrowd crowd;
  const Status added = crowd->agent(0).add_channel(std::make_unique<BlendSpaceChannel>(
      std::vector<BlendPoint>{{.clip = gaits::walk, .parameter = 0.0F, .pace = Pace::gait},
                              {.clip = gaits::bend, .parameter = 1.0F, .pace = Pace::gait}},
      0.5F, false));
  EXPECT_TRUE(added) << added.error().message;
  return crowd;
}

TEST(TurningMotion, OfABlendTurnsByTheShareOfItsClips) {
  const GaitCrowd crowd = blended();
  const RootMotion second = motion(crowd, Ticks{}, ticks_per_second);
  EXPECT_NEAR(second.yaw, 0.5 * quarter, 0.03) << "clips of other lengths keep step";
  EXPECT_GT(glm::length(second.translation), 1.3);
}

TEST(TurningMotion, OfABlendComposesOfItsPieces) {
  GaitCrowd crowd = blended();
  std::mt19937_64 random(4);
  RootMotion pieces;
  Ticks at{};
  for (int i = 0; i < 100; ++i) {
    const Ticks next = at + Ticks{static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * tick_rate))};
    pieces = compose(pieces, motion(crowd, at, next));
    at = next;
    ASSERT_LT(apart(pieces, motion(crowd, Ticks{}, at)), 1e-6 * (1 + i)) << i;
  }
}

}  // namespace
}  // namespace throng::anim::turning_motion_test
