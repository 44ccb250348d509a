#include "engine/anim/entity/ragdoll_entity.h"

#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/entity_run.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim::ragdoll_entity_test {
namespace {

using Phase = RagdollEntity::Phase;
constexpr Ticks frame = ticks_per_second / 60;

/// A rag-doll in memory of its own, updated as a PU would.
class RagdollOfAPerson : public testing::Test {
 protected:
  RagdollOfAPerson() {
    handle_ = pools_.create(pools_.add_kind(kind_));
    ragdoll().source = handle_;  // anything that is not invalid
    pools_.private_as<RagdollMemory>(handle_).ground = {};
    source_.linear_velocity[2] = 1.5F;
  }
  RagdollEntity& ragdoll() { return pools_.as<RagdollEntity>(handle_); }
  const EntityInStore& store() {
    store_ = {.block = pools_.block(handle_), .prepared = prepared_, .layout = &pools_.layout(handle_)};
    return store_;
  }
  void update(Ticks delta, const PoseView& pose) {
    ragdoll().state.delta_time += delta;
    const SourceRow source{reinterpret_cast<const std::byte*>(&source_), 0, nullptr};
    kind_.advance({.first = store(), .sources = {&source, ragdoll().source.valid() ? 1U : 0U}});
    kind_.pose_whole(store(), pose);
    EXPECT_EQ(ragdoll().state.delta_time, Ticks{});
  }

  Model person_ = ragdoll_stage::person();
  RagdollRig rig_ = ragdoll_stage::rig_of(person_);
  EntityKind kind_ = ragdoll_kind(rig_);
  EntityPools pools_{person_.skeleton.bone_count(), rigid_components, Residency::transient};
  AnimationStateHeader source_{};
  Handle handle_;
  alignas(64) std::byte prepared_[64]{};
  EntityInStore store_;
};

TEST_F(RagdollOfAPerson, KeepsItsTransformsUnderEverySchedule) {
  EXPECT_NE(pools_.layout(handle_).transforms_offset, 0U);
}

TEST_F(RagdollOfAPerson, PassesItsSourceOnUntilItHasSeenTwoPoses) {
  std::mt19937 random(5);
  HeldPose pose(person_.skeleton);
  pose.shake(random, 0.2F);
  const std::vector<float> before = pose.floats();
  update(frame, pose.view());
  EXPECT_EQ(ragdoll().phase, Phase::animated);
  let_go(ragdoll());
  update(frame, pose.view());
  EXPECT_EQ(ragdoll().phase, Phase::second);
  EXPECT_EQ(ragdoll().state.linear_velocity[2], 1.5F);
  update(Ticks{}, pose.view());
  EXPECT_EQ(ragdoll().phase, Phase::second) << "without time there is no movement to be had";
  update(frame, pose.view());
  EXPECT_TRUE(is_loose(ragdoll()));
  EXPECT_EQ(pose.floats(), before);
}

TEST_F(RagdollOfAPerson, GoesOnAsItsSourceMovedAndThenStandsInNobodysWay) {
  HeldPose pose(person_.skeleton);
  let_go(ragdoll());
  update(frame, pose.view());
  update(frame, pose.view());
  const RagdollState& bodies = pools_.private_as<RagdollMemory>(handle_).bodies;
  EXPECT_FLOAT_EQ(bodies.bodies[0].velocity.z, 1.5F);
  ragdoll().source = {};
  EXPECT_TRUE(pools_.sources(handle_).empty());
  update(frame, pose.view());
  EXPECT_GT(pose.view().position(find_bone(person_.skeleton, "hips")).z, 0.01F);
  EXPECT_EQ(ragdoll().state.linear_velocity[2], 0.0F) << "its placement stays";
}

TEST_F(RagdollOfAPerson, TakesAPushOnce) {
  HeldPose pose(person_.skeleton);
  source_.linear_velocity[2] = 0.0F;
  let_go(ragdoll());
  ragdoll().impulse[0] = 30.0F;
  ragdoll().push_place[1] = 1.0F;
  update(frame, pose.view());
  update(frame, pose.view());
  EXPECT_EQ(ragdoll().impulse[0], 30.0F) << "it is not loose yet";
  update(frame, pose.view());
  EXPECT_EQ(ragdoll().impulse[0], 0.0F);
  EXPECT_GT(pools_.private_as<RagdollMemory>(handle_).bodies.bodies[0].velocity.x, 0.05F);
}

TEST_F(RagdollOfAPerson, SeesNoMovementInAChangeOfDetail) {
  HeldPose pose(person_.skeleton);
  source_.linear_velocity[2] = 0.0F;
  std::mt19937 random(6);
  pose.shake(random, 0.4F);
  let_go(ragdoll());
  PoseView trunk = pose.view();
  trunk.bone_count = find_bone(person_.skeleton, "head") + 1;
  update(frame, trunk);
  update(frame, pose.view());
  const RagdollState& bodies = pools_.private_as<RagdollMemory>(handle_).bodies;
  for (std::size_t body = 0; body < rig_.bodies.size(); ++body) {
    EXPECT_LT(glm::length(bodies.bodies[body].velocity), 1e-4F) << body;
  }
}

}  // namespace
}  // namespace throng::anim::ragdoll_entity_test
