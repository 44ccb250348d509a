#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim::ragdoll_motion_test {
namespace {

using namespace ragdoll_stage;

class Ragdoll : public testing::Test {
 protected:
  Model model_ = person();
  RagdollRig rig_ = rig_of(model_);
};

constexpr double step = 1.0 / 120.0;

TEST_F(Ragdoll, FallsToTheGroundAndFoldsOnTheWay) {
  const RagdollState state = fallen(rig_, 4.0);
  EXPECT_LT(state.bodies[0].position.y, 0.45F);  // the pelvis stood at 0.95
  float head = 0.0F;
  for (const glm::dvec3& origin : bone_origins(model_, rig_, state))
    head = std::max(head, static_cast<float>(origin.y));
  EXPECT_LT(head, 0.8F);
  double bend = 0.0;
  for (std::size_t b = 1; b < rig_.bodies.size(); ++b) {
    const glm::quat& parent = state.bodies[rig_.bodies[b].parent].rotation;
    bend = std::max(
        bend,
        2.0 * std::acos(std::min(1.0, std::abs(glm::dot(glm::dquat(parent), glm::dquat(state.bodies[b].rotation))))));
  }
  EXPECT_GT(bend, glm::radians(30.0));
}

TEST_F(Ragdoll, AtRestStaysAtRestForTenSeconds) {
  RagdollState state = fallen(rig_, 6.0);
  const RagdollState rest = state;
  for (int second = 0; second < 10; ++second) {
    run(rig_, 1.0, state);
    for (std::size_t b = 0; b < rig_.bodies.size(); ++b) {
      ASSERT_LT(glm::distance(state.bodies[b].position, rest.bodies[b].position), 0.001F) << second;
    }
  }
}

TEST_F(Ragdoll, LiesStillBeforeItIsPutToSleep) {
  RagdollState state = fallen(rig_, 6.0);
  ASSERT_EQ(state.asleep, 1);
  const RagdollState rest = state;
  wake_ragdoll(state);
  run(rig_, 0.4, state);
  ASSERT_EQ(state.asleep, 0);
  for (std::size_t b = 0; b < rig_.bodies.size(); ++b) {
    EXPECT_LT(glm::distance(state.bodies[b].position, rest.bodies[b].position), 0.01F) << b;
  }
}

TEST_F(Ragdoll, EndsInsideItsLimits) {
  // A joint that carries weight gives by what gravity turns it in one small step and a pass does not take back.
  EXPECT_LT(farthest_outside_limits(rig_, fallen(rig_, 6.0)), glm::radians(0.5));
}

TEST_F(Ragdoll, EndsInsideItsLimitsWhenThePoseWasOutside) {
  Pose pose(model_.skeleton.bone_count());
  for (std::size_t b = 4; b < rig_.bodies.size(); ++b) {
    pose.view().set_rotation(rig_.bodies[b].bone, glm::angleAxis(-1.2F, glm::vec3(1.0F, 0.0F, 0.0F)));
  }
  RagdollState state;
  ragdoll_from_pose(rig_, {.before = pose.view(), .now = pose.view()}, state);
  ASSERT_GT(farthest_outside_limits(rig_, state), glm::radians(20.0));
  run(rig_, 6.0, state);
  EXPECT_LT(farthest_outside_limits(rig_, state), glm::radians(0.5));
}

TEST_F(Ragdoll, NeverGainsEnergy) {
  RagdollState state = standing(rig_);
  // The bind pose has its toes in the ground; they come out of it first.
  run(rig_, 0.1, state);
  for (int i = 0; i < 600; ++i) {
    const double before = energy(rig_, state);
    run(rig_, step, state);
    ASSERT_LT(energy(rig_, state), before + 0.02) << i * step;  // rounding, of 700 J
  }
}

TEST_F(Ragdoll, KeepsItsMomentumInTheAir) {
  RagdollState state = standing(rig_);
  push_ragdoll(rig_, 6, {0.0F, 0.0F, 5.0F}, state.bodies[6].position, state);
  const auto momentum = [&] {
    glm::vec3 sum(0.0F);
    for (std::size_t b = 0; b < rig_.bodies.size(); ++b) sum += state.bodies[b].velocity / rig_.bodies[b].inverse_mass;
    return sum;
  };
  const float before = momentum().z;
  run(rig_, 0.5, state, {.height = -100.0F});
  EXPECT_NEAR(momentum().z, before, 0.1F * before);  // the air takes 5 per cent
}

TEST_F(Ragdoll, NoBoneFallsThroughTheGroundInAThousandPushes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-1.0F, 1.0F);
  const auto vector = [&] { return glm::vec3(any(random), any(random), any(random)); };
  const RagdollState lying = fallen(rig_, 3.0);
  RagdollState state = lying;
  for (int push = 0; push < 1000; ++push) {
    if (push % 20 == 0) state = lying;
    const int body = push % static_cast<int>(rig_.bodies.size());
    push_ragdoll(rig_, body, 200.0F * vector(), state.bodies[body].position + 0.1F * vector(), state);
    for (int frame = 0; frame < 3; ++frame) {
      run(rig_, 1.0 / 30.0, state);
      // A body at 30 m/s goes 4 cm in a small step before the ground and its joints have their say.
      ASSERT_LT(deepest(rig_, state), 0.02F) << push;
      for (const glm::dvec3& origin : bone_origins(model_, rig_, state)) ASSERT_GT(origin.y, -0.03) << push;
    }
  }
}

TEST_F(Ragdoll, KeepsTheLengthsOfItsBones) {
  const auto bind = bone_origins(model_, rig_, standing(rig_));
  RagdollState state = fallen(rig_, 0.7);
  push_ragdoll(rig_, 3, {40.0F, 10.0F, -60.0F}, state.bodies[3].position, state);
  run(rig_, 0.05, state);
  const auto posed = bone_origins(model_, rig_, state);
  for (std::size_t bone = 2; bone < bind.size(); ++bone) {
    const auto parent = static_cast<std::size_t>(model_.skeleton.bones[bone].parent);
    EXPECT_NEAR(glm::distance(posed[bone], posed[parent]), glm::distance(bind[bone], bind[parent]), 1e-6);
  }
}

TEST_F(Ragdoll, HoldsTogetherInsideAsThePoseShowsIt) { EXPECT_LT(widest_gap(rig_, fallen(rig_, 6.0)), 0.001F); }

TEST_F(Ragdoll, LiesOnASlopeWithoutSliding) {
  const float angle = glm::radians(20.0F);
  const GroundPlane slope{.normal = {0.0F, std::cos(angle), std::sin(angle)}};
  RagdollState state = standing(rig_);
  run(rig_, 6.0, state, slope);
  EXPECT_EQ(state.asleep, 1);
  EXPECT_LT(deepest(rig_, state, slope), 0.005F);
}

TEST_F(Ragdoll, TakesAPlaneForEachBody) {
  std::vector<GroundPlane> steps(rig_.bodies.size());
  for (std::size_t b = 0; b < steps.size(); ++b) steps[b].height = b < 4 ? 0.3F : 0.0F;
  RagdollState state = standing(rig_);
  ragdoll_step(rig_, steps, to_ticks(5.0), state);
  for (std::size_t b = 0; b < 4; ++b) EXPECT_GT(state.bodies[b].position.y, 0.3F) << b;
}

TEST_F(Ragdoll, StaysFiniteUnderAnyPush) {
  for (const float size : {1e4F, 1e20F, 3e38F}) {
    RagdollState state = standing(rig_);
    push_ragdoll(rig_, 6, {size, size, -size}, {size, 0.0F, size}, state);
    run(rig_, 3.0, state);
    EXPECT_TRUE(is_finite(rig_, state)) << size;
    EXPECT_LT(deepest(rig_, state), 0.02F) << size;
  }
}

}  // namespace
}  // namespace throng::anim::ragdoll_motion_test
