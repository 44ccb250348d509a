#include "engine/anim/entity/inertialiser.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::inertialiser_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr float half_life = 0.05F;

struct Following {
  Following() : one(rig.held(0.0F)), other(rig.held(1.0F, 0.5F)), entity(rig.create(EntityPools::inertialisers)) {
    get().target = one;
  }
  Inertialiser& get() { return rig.as<Inertialiser>(entity); }
  void change_to(Handle next) { retarget(get(), next, get().target, half_life); }
  float after(Ticks delta) {
    rig.update(entity, delta);
    return rig.angle(entity, 17);
  }
  EntityRig rig;
  Handle one;
  Handle other;
  Handle entity;
};

TEST(Inertialiser, FollowsItsTargetToTheBit) {
  Following following;
  following.rig.set_pose(following.one, 0.7F, 0.3F);
  following.after(frame);
  EXPECT_EQ(following.rig.floats(following.entity), following.rig.floats(following.one));
  EXPECT_TRUE(is_over(following.get()));
}

TEST(Inertialiser, ReadsTheOldSourceForTwoUpdatesAndThenNoMore) {
  Following following;
  following.after(frame);
  following.change_to(following.other);
  EXPECT_EQ(following.rig.pools().sources(following.entity).size(), 2U);
  following.after(frame);
  EXPECT_FALSE(has_left(following.get()));
  following.after(frame);
  EXPECT_TRUE(has_left(following.get()));
  EXPECT_EQ(following.rig.pools().sources(following.entity).size(), 1U);
}

TEST(Inertialiser, LeavesWithoutAJumpAndArrives) {
  Following following;
  following.after(frame);
  following.change_to(following.other);
  float before = following.after(frame);
  EXPECT_NEAR(before, 0.0F, 1e-6F) << "what was shown is still shown";
  float largest_step = 0.0F;
  for (int i = 0; i < 60; ++i) {
    const float now = following.after(frame);
    EXPECT_GE(now, before - 1e-5F) << "from rest to rest it neither turns back nor passes by";
    largest_step = std::max(largest_step, now - before);
    before = now;
  }
  EXPECT_LT(largest_step, 0.3F) << "a cut would have been 1";
  EXPECT_TRUE(is_over(following.get()));
  EXPECT_EQ(following.rig.floats(following.entity), following.rig.floats(following.other));
}

TEST(Inertialiser, HalvesTheOffsetInItsHalfLife) {
  Following following;
  following.after(frame);
  following.change_to(following.other);
  following.after(frame);
  following.after(frame);
  EXPECT_NEAR(following.after(to_ticks(static_cast<double>(half_life))), 0.5F, 1e-3F);
}

TEST(Inertialiser, CarriesTheMotionOn) {
  Following following;
  float angle = 0.0F;
  const auto turn = [&] {
    angle += 0.02F;
    following.rig.set_pose(following.one, angle);
    return following.after(frame);
  };
  for (int i = 0; i < 10; ++i) turn();
  following.rig.set_pose(following.other, 0.2F);
  following.change_to(following.other);
  turn();
  const float before = turn();
  EXPECT_GT(following.after(frame), before) << "the offset moves on before it decays";
}

TEST(Inertialiser, TakesNoVelocityFromAnUpdateInWhichNoTimePassed) {
  Following following;
  following.after(frame);
  following.change_to(following.other);
  following.after(frame);
  following.after(Ticks{});
  EXPECT_FALSE(has_left(following.get()));
  following.after(frame);
  EXPECT_TRUE(has_left(following.get()));
  for (const float value : following.rig.floats(following.entity)) EXPECT_TRUE(std::isfinite(value));
}

TEST(Inertialiser, InterruptedInTheMiddleGoesOnFromWhatIsShown) {
  Following following;
  const Handle third = following.rig.held(-1.0F);
  following.after(frame);
  following.change_to(following.other);
  float before = 0.0F;
  for (int i = 0; i < 5; ++i) before = following.after(frame);
  following.change_to(third);
  float largest_step = 0.0F;
  for (int i = 0; i < 60; ++i) {
    const float now = following.after(frame);
    largest_step = std::max(largest_step, std::abs(now - before));
    before = now;
  }
  EXPECT_LT(largest_step, 0.5F) << "a cut would have been more than 1.5";
  EXPECT_NEAR(before, -1.0F, 1e-5F);
}

TEST(Inertialiser, ShowsBonesThatItGainsAfterAChangeWhereTheirTargetHasThem) {
  Following following;
  following.after(frame);
  following.change_to(following.other);
  following.after(frame);
  following.after(frame);
  following.change_to(following.one);
  for (int i = 0; i < 3; ++i) following.rig.update(following.entity, frame, 1);
  following.rig.update(following.entity, frame);
  EXPECT_GT(following.rig.angle(following.entity, 3), 0.05F) << "the offset is on its way out";
  EXPECT_EQ(following.rig.angle(following.entity, 17), 0.0F) << "an offset of an earlier change would come back whole";
}

TEST(Inertialiser, MovesAsItsTargetDoes) {
  Following following;
  following.rig.as<HeldState>(following.one).state.linear_velocity[2] = 1.4F;
  following.after(frame);
  EXPECT_EQ(following.get().state.linear_velocity[2], 1.4F);
}

}  // namespace
}  // namespace throng::anim::inertialiser_test
