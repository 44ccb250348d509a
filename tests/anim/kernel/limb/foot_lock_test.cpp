// What locks promise, by their definition, which kernels are held to (foot_placement_strip_test.cpp).

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/kernel/limb/foot_lock_reference.h"

namespace throng::anim::foot_lock_test {
namespace {

constexpr float frame = 1.0F / 60.0F;

/// A foot over flat ground that the body carries along z at 1 m/s.
class FootLockOfAWalk : public testing::Test {
 protected:
  Footing step(float planted) {
    posed_.place.z += frame;
    return step_foot_lock(lock_, posed_, planted, options_, frame);
  }
  Footing step_for(int frames, float planted) {
    for (int i = 1; i < frames; ++i) step(planted);
    return step(planted);
  }
  FootLock lock_;
  FootLockOptions options_;
  Footing posed_;
};

TEST_F(FootLockOfAWalk, LeavesAFootInTheAirWhereThePoseHasIt) {
  EXPECT_EQ(step_for(10, 0.0F).place, posed_.place);
  EXPECT_FALSE(lock_.locked());
}

TEST_F(FootLockOfAWalk, StartsOnTheGroundThatIsThere) {
  posed_.normal = glm::normalize(glm::vec3(0.3F, 1.0F, 0.0F));
  EXPECT_EQ(step(1.0F).normal, posed_.normal);
}

TEST_F(FootLockOfAWalk, KeepsAPlantedFootToTheBitWhereItCameDown) {
  step_for(10, 0.0F);
  const Footing down = step(1.0F);
  EXPECT_EQ(down.place, posed_.place);
  EXPECT_EQ(step_for(12, 1.0F).place, down.place);
}

TEST_F(FootLockOfAWalk, EasesALiftedFootBackInAFixedTime) {
  step_for(12, 1.0F);
  float last = glm::distance(step(0.0F).place, posed_.place);
  EXPECT_GT(last, 0.19F) << "it is let go where it stood";
  for (int i = 0; i < 12; ++i) {
    const float away = glm::distance(step(0.0F).place, posed_.place);
    EXPECT_LT(away, last);
    EXPECT_GT(away, last - 0.03F) << "and does not jump";
    last = away;
  }
  EXPECT_EQ(step(0.0F).place, posed_.place) << "0.2 s later";
}

TEST_F(FootLockOfAWalk, LocksAgainWhereTheFootIsOnItsWayBack) {
  step_for(12, 1.0F);
  const Footing easing = step_for(5, 0.0F);
  const Footing locked = step(1.0F);
  EXPECT_LT(glm::distance(locked.place, easing.place), 0.05F);
  EXPECT_GT(glm::distance(locked.place, posed_.place), 0.02F);
  EXPECT_EQ(step(1.0F).place, locked.place);
}

TEST_F(FootLockOfAWalk, LetsAFootGoThatIsLeftTooFarBehindUntilItsNextStep) {
  step_for(40, 1.0F);
  EXPECT_FALSE(lock_.locked());
  EXPECT_EQ(step_for(40, 1.0F).place, posed_.place);
  step(0.0F);
  step(1.0F);
  EXPECT_TRUE(lock_.locked());
}

TEST_F(FootLockOfAWalk, StepsBackFromWhereItsLegLeftItAndLocksThere) {
  step_for(12, 1.0F);
  lock_.last_ball = 0.5F * (posed_.place + lock_.place);
  const glm::vec3 left_at = lock_.last_ball;
  const auto step_back = [&](float reached) {
    posed_.place.z += frame;
    return step_foot_lock(lock_, posed_, 1.0F, options_, frame, reached);
  };
  EXPECT_LT(glm::distance(step_back(0.5F).place, left_at), 1e-6F);
  EXPECT_FALSE(lock_.locked());
  float highest = 0.0F;
  for (int i = 0; i < 11; ++i) {
    step_back(1.0F);
    EXPECT_FALSE(lock_.locked());
    highest = std::max(highest, rise_of_step(lock_, 1.0F, options_));
  }
  EXPECT_NEAR(highest, step_height * glm::length(lock_.offset), 1e-3F) << "it does not drag over the ground";
  step_back(1.0F);
  step_back(1.0F);
  EXPECT_TRUE(lock_.locked());
  EXPECT_EQ(rise_of_step(lock_, 1.0F, options_), 0.0F);
}

TEST_F(FootLockOfAWalk, DoesNotReachOutAgainOnItsWayBack) {
  step_for(12, 1.0F);
  step(0.0F);
  const float offset = lock_.offset.z;
  step_foot_lock(lock_, posed_, 0.0F, options_, frame, 0.5F);
  EXPECT_FLOAT_EQ(lock_.offset.z, 0.5F * offset);
}

TEST_F(FootLockOfAWalk, HoldsAFootOutOfReachUntilTimePasses) {
  const Footing down = step_for(12, 1.0F);
  EXPECT_EQ(step_foot_lock(lock_, posed_, 1.0F, options_, 0.0F, 0.5F).place, down.place);
  EXPECT_TRUE(lock_.locked());
}

TEST_F(FootLockOfAWalk, EasesFromOneHeightOfTheGroundToAnother) {
  step_for(12, 1.0F);
  posed_.place.y = 0.2F;
  EXPECT_LT(step(0.0F).place.y, 0.01F);
  EXPECT_EQ(step_for(13, 0.0F).place.y, 0.2F);
}

TEST_F(FootLockOfAWalk, DoesNothingWhenItIsOff) {
  options_.enabled = false;
  EXPECT_EQ(step_for(5, 1.0F).place, posed_.place);
}

TEST(FootLock, MeasuresHowFarAStandingFootSlid) {
  FootLock lock;
  for (int i = 0; i <= 10; ++i) measure_slide(lock, {0.01F * static_cast<float>(i), 0.5F, 0.0F}, 1.0F, frame);
  EXPECT_NEAR(lock.slid, 0.1F, 1e-6F);
  EXPECT_NEAR(lock.standing_seconds, 10.0F * frame, 1e-6F);
  measure_slide(lock, {5.0F, 0.0F, 0.0F}, 0.0F, frame);
  EXPECT_NEAR(lock.slid, 0.1F, 1e-6F) << "what it does in the air does not count";
  measure_slide(lock, {9.0F, 0.0F, 0.0F}, 1.0F, frame);
  EXPECT_EQ(lock.slid, 0.0F) << "and every step counts for itself";
}

TEST(FootLock, KnowsTheHeightOfSlopingGround) {
  const Footing slope{.place = {1.0F, 2.0F, 3.0F}, .normal = glm::normalize(glm::vec3(-0.5F, 1.0F, 0.0F))};
  EXPECT_NEAR(ground_height(slope, 3.0F, 7.0F), 3.0F, 1e-6F);
}

}  // namespace
}  // namespace throng::anim::foot_lock_test
