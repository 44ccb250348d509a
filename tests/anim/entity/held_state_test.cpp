#include "engine/anim/entity/held_state.h"

#include <gtest/gtest.h>

#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::held_state_test {
namespace {

TEST(HeldState, BeginsAsTheBindPose) {
  EntityRig rig;
  const Handle state = rig.create(EntityPools::held_states);
  for (int bone = 0; bone < EntityRig::bones; ++bone) {
    EXPECT_EQ(rig.pose(state).rotation(bone), glm::quat(1.0F, 0.0F, 0.0F, 0.0F));
    EXPECT_EQ(rig.pose(state).position(bone), glm::vec3(0.0F));
  }
}

TEST(HeldState, KeepsItsPoseWhateverTimePasses) {
  EntityRig rig;
  const Handle state = rig.held(0.4F, 0.2F);
  const std::vector<float> before = rig.floats(state);
  for (int i = 0; i < 10; ++i) rig.update(state, ticks_per_second);
  EXPECT_EQ(rig.floats(state), before);
  EXPECT_EQ(rig.as<HeldState>(state).state.delta_time, Ticks{});
}

TEST(HeldState, IsASourceLikeAnyOther) {
  EntityRig rig;
  const Handle state = rig.held(0.0F, 2.0F);
  const Handle blender = rig.hold(rig.held(0.0F, 1.0F), state, 0.25F);
  rig.update(blender, Ticks{1});
  EXPECT_FLOAT_EQ(rig.place(blender, 3), 1.25F);
  rig.set_pose(state, 0.0F, 3.0F);
  rig.update(blender, Ticks{1});
  EXPECT_FLOAT_EQ(rig.place(blender, 3), 1.5F) << "what was written between frames is there in the next";
}

TEST(HeldState, HasItsTransformsUnderEverySchedule) {
  EntityPools pools(20, rigid_components, Residency::transient);
  const Handle state = pools.create(EntityPools::held_states);
  ASSERT_NE(pools.layout(state).transforms_offset, 0U);
  transforms_of(pools.state(state))[0] = 0.5F;
  pools.set_residency(Residency::resident);
  EXPECT_EQ(transforms_of(pools.state(state))[0], 0.5F);
  pools.set_residency(Residency::transient);
  EXPECT_EQ(transforms_of(pools.state(state))[0], 0.5F);
}

}  // namespace
}  // namespace throng::anim::held_state_test
