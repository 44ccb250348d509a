// Arms that hold something, over what the whole body does.
#include "app/show/stage/held_arms.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/stage/hand_height.h"
#include "tests/app/show/stage/watched_stage.h"

namespace throng::app::held_arms_test {
namespace {

constexpr int people = 12;

class HeldArmsTest : public test::WatchedStage {
 protected:
  void SetUp() override {
    open({.scene = Scene::plaza,
          .agents = people,
          .lod = {.rule = LodRule::off, .smooth = true},
          .system = {.pus = 2, .hash = true}});
  }

  void give(HeldThing thing) { stage_->animated().give(std::vector<HeldThing>(people, thing)); }
  std::size_t shown() const { return stage_->animated().details().held_arms().shown(); }

  float height_of(std::uint32_t agent, glm::vec3 at_rest) const {
    return test::height_in_hand(*stage_, agent, at_rest);
  }
};

TEST_F(HeldArmsTest, OfEmptyHandsChangeNoPose) {
  pass(60);
  const std::uint64_t before = hash();
  open(stage_->tuning());
  give(HeldThing::nothing);
  pass(60);
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(shown(), 0U);
}

TEST_F(HeldArmsTest, AreOfThoseWhoseThingsAreDrawnAlone) {
  give(HeldThing::bag);
  pass(2);
  EXPECT_GT(shown(), people / 2U) << "all but those who sit";
  camera_ = camera_at({.x = 0, .y = 300, .z = 900, .yaw = 0, .pitch = -18});
  pass(2);
  EXPECT_EQ(shown(), 0U);
}

TEST_F(HeldArmsTest, GiveTheSamePosesForAnyNumberOfPus) {
  give(HeldThing::umbrella);
  pass(90);
  const std::uint64_t two = hash();
  Tuning tuning = stage_->tuning();
  tuning.system.pus = 1;
  open(tuning);
  give(HeldThing::umbrella);
  pass(90);
  EXPECT_EQ(hash(), two);
}

TEST_F(HeldArmsTest, GoBackInTimeWithTheCrowd) {
  give(HeldThing::bag);
  pass(40);
  ASSERT_TRUE(rewind_.go_back(*stage_));
  pass(5);
  EXPECT_GT(shown(), 0U);
  EXPECT_LE(shown(), stage_->posed().selection().visible.size());
}

TEST_F(HeldArmsTest, HoldAFistUpWhileSomebodyWalks) {
  ASSERT_TRUE(stage_->posed().keep_joints(stage_->animated().system()));
  give(HeldThing::umbrella);
  pass(60);
  for (const anim::VisibleAgent& agent : stage_->posed().selection().visible) {
    if (stage_->crowd().minds().roles()[agent.agent] == Role::sit) continue;
    EXPECT_GT(height_of(agent.agent, glm::vec3(0)), 1.0F) << agent.agent;
  }
}

TEST_F(HeldArmsTest, SetAStickOnTheGroundWithEverySecondStep) {
  ASSERT_TRUE(stage_->posed().keep_joints(stage_->animated().system()));
  give(HeldThing::stick);
  pass(90);
  const glm::vec3 tip(0.711F, -0.635F, 0.0F);  // of assets/mannequin/held.h: 0.87 m along the fingers from the handle
  int on_the_ground = 0;
  int lifted = 0;
  for (int i = 0; i < 120; ++i) {
    pass(1);
    for (const anim::VisibleAgent& agent : stage_->posed().selection().visible) {
      if (stage_->crowd().minds().roles()[agent.agent] != Role::walk) continue;
      const float height = height_of(agent.agent, tip);
      on_the_ground += std::abs(height) < 0.025F ? 1 : 0;
      lifted += height > 0.04F ? 1 : 0;
      EXPECT_GT(height, -0.06F) << agent.agent;
    }
  }
  EXPECT_GT(on_the_ground, 100);
  EXPECT_GT(lifted, 30);
  EXPECT_LT(lifted, 2 * on_the_ground);
}

}  // namespace
}  // namespace throng::app::held_arms_test
