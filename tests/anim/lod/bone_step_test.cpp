#include "engine/anim/lod/bone_step.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::anim::bone_step_test {
namespace {

using testing::ElementsAre;

std::vector<BoneStep> steps(BoneStep from, std::uint8_t wanted, int count) {
  std::vector<BoneStep> taken;
  for (int i = 0; i < count; ++i) taken.push_back(from = next_step(from, wanted));
  return taken;
}

TEST(BoneStep, LeavesALevelOverTwoUpdatesAndThenShowsTheCoarserOne) {
  EXPECT_THAT(steps(settled_at(0), 2, 4),
              ElementsAre(BoneStep{0, 2, 1}, BoneStep{0, 2, 2}, settled_at(2), settled_at(2)));
}

TEST(BoneStep, ComesBackWithItsBonesStandingStillFirst) {
  EXPECT_THAT(steps(settled_at(2), 0, 4),
              ElementsAre(BoneStep{0, 2, 2}, BoneStep{0, 2, 1}, settled_at(0), settled_at(0)));
}

TEST(BoneStep, TurnsRoundOnTheWay) {
  EXPECT_THAT(steps({0, 1, 2}, 0, 2), ElementsAre(BoneStep{0, 1, 1}, settled_at(0)));
  EXPECT_THAT(steps({0, 1, 1}, 1, 2), ElementsAre(BoneStep{0, 1, 2}, settled_at(1)));
}

TEST(BoneStep, GetsAnywhereFromAnywhere) {
  for (std::uint8_t level = 0; level < 4; ++level) {
    for (std::uint8_t fade = level; fade < 4; ++fade) {
      for (std::uint8_t wanted = 0; wanted < 4; ++wanted) {
        const auto halves = static_cast<std::uint8_t>(fade == level ? 0 : 1);
        EXPECT_EQ(steps({level, fade, halves}, wanted, 8).back(), settled_at(wanted));
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::bone_step_test
