// A state machine plays one state at a time, and takes its transitions by the clock.

#include "engine/anim/agent/channel/state_machine_channel.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/agent/channel/machine_crowd.h"

namespace throng::anim::state_machine_channel_test {
namespace {

using namespace machine_crowd;

float distance(const CrowdRig& one, const CrowdRig& other) {
  float farthest = 0.0F;
  for (std::size_t bone = 0; bone < one.joints().size(); ++bone) {
    farthest = std::max(farthest, glm::distance(one.joints()[bone], other.joints()[bone]));
  }
  return farthest;
}

/// A crowd that plays a clip as it is at a time of it after the next step.
CrowdRig playing(const PlayRequest& request) {
  CrowdRig crowd;
  crowd->agent(0).play(request);
  return crowd;
}

TEST(StateMachineChannel, PlaysTheStateThatItStartsIn) {
  MachineCrowd crowd;
  CrowdRig alone = playing({.clip = 0});
  for (CrowdRig* one : {static_cast<CrowdRig*>(&crowd), &alone}) one->step(7);
  EXPECT_TRUE(crowd.bones_unlike(alone).empty());
  EXPECT_EQ(crowd.current(), move);
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(StateMachineChannel, BlendsByAnInputAsABlendSpaceDoes) {
  MachineCrowd crowd;
  CrowdRig space;
  const std::vector<BlendPoint> points{{.clip = 0, .parameter = 0.0F}, {.clip = 1, .parameter = 2.0F}};
  ASSERT_TRUE(space->agent(0).add_channel(std::make_unique<BlendSpaceChannel>(points, 0.0F, false)));
  for (const float value : {0.5F, 1.5F, 2.0F, 0.25F}) {
    crowd.set(speed, value);
    const auto change = [&](BlendSpaceChannel& own) { own.set_parameter(value); };
    ASSERT_TRUE(space->agent(0).change<BlendSpaceChannel>(first, change));
    for (CrowdRig* one : {static_cast<CrowdRig*>(&crowd), &space}) one->step(11);
    EXPECT_TRUE(crowd.bones_unlike(space).empty()) << value;
  }
}

TEST(StateMachineChannel, TakesATransitionWhenItsConditionHoldsAndFades) {
  MachineCrowd crowd;
  crowd.step(10);
  const std::vector<glm::vec3> before = crowd.joints();
  crowd.set(jump);
  EXPECT_EQ(crowd.current(), leap);
  EXPECT_EQ(crowd.channel().entered_at(), crowd->clock());
  crowd.step();
  EXPECT_EQ(crowd.entities(), 3U) << "a fade";
  CrowdRig alone = playing({.clip = 2, .loop = false});
  crowd.step(fade_frames);
  alone.step(fade_frames + 1);
  EXPECT_LT(distance(crowd, alone), 1e-5F) << "the fade is over, and the clip began when the trigger came";
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(StateMachineChannel, EndsTheFadeOfAnEndWithTheClip) {
  MachineCrowd crowd;
  crowd.set(jump);
  const Ticks begins = duration_of(2) - to_ticks(fade);
  crowd.step(frames_to(begins) - 1);
  EXPECT_EQ(crowd.current(), leap);
  crowd.step(1);
  EXPECT_EQ(crowd.current(), move);
  EXPECT_EQ(crowd.channel().entered_at(), begins) << "to the tick, whatever the frames are";
  crowd.step(fade_frames + 1);
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(StateMachineChannel, UsesATriggerOnce) {
  MachineCrowd crowd;
  crowd.set(jump);
  EXPECT_EQ(crowd.channel().input(jump), 0.0F) << "used";
  crowd.step(frames_to(duration_of(2)) + 2);
  EXPECT_EQ(crowd.current(), move);
  crowd.step(200);
  EXPECT_EQ(crowd.current(), move);
}

TEST(StateMachineChannel, KeepsATriggerUntilATransitionAsksForIt) {
  MachineCrowd crowd;
  crowd.set(jump);
  crowd.step(3);
  crowd.set(jump);
  crowd.step(frames_to(duration_of(2)));
  EXPECT_EQ(crowd.current(), leap) << "again, as soon as it has landed";
  EXPECT_EQ(crowd.channel().entered_at(), duration_of(2) - to_ticks(fade));
}

TEST(StateMachineChannel, WaitsInAStateForItsTime) {
  MachineCrowd crowd;
  crowd.set(hurt);
  EXPECT_EQ(crowd.current(), fall);
  crowd.step(44);
  EXPECT_EQ(crowd.current(), fall);
  crowd.step(2);
  EXPECT_EQ(crowd.current(), lie);
  EXPECT_EQ(crowd.channel().entered_at(), to_ticks(0.75));
}

TEST(StateMachineChannel, LeavesALoopAtTheEndOfALoop) {
  MachineCrowd crowd;
  crowd.set(hurt);
  const Ticks lies_at = to_ticks(0.75), length = duration_of(4) * 2;
  crowd.step(frames_to(lies_at + length + length / 2));
  ASSERT_EQ(crowd.current(), lie);
  crowd.set(hurt, 0.0F);
  EXPECT_EQ(crowd.current(), lie) << "in the middle of the second loop";
  crowd.step(frames_to(length / 2) + 1);
  EXPECT_EQ(crowd.current(), move);
  EXPECT_EQ(crowd.channel().entered_at(), lies_at + length * 2 - to_ticks(fade));
}

TEST(StateMachineChannel, TakesTheFirstOfTransitionsThatAreDueTogether) {
  MachineCrowd crowd;
  const auto both = [](StateMachineChannel& own) {
    own.set(hurt, 1.0F);
    own.set(jump, 1.0F);
  };
  ASSERT_TRUE(crowd->agent(0).change<StateMachineChannel>(first, both));
  crowd.step();
  EXPECT_EQ(crowd.current(), fall) << "it leaps first, and is hurt in the same moment";
  EXPECT_EQ(crowd.channel().input(jump), 0.0F);
}

TEST(StateMachineChannel, FollowsATransitionFromAnyState) {
  MachineDescription from = description();
  from.transitions = {{.from = "*", .to = "fall", .when = {"hurt"}},
                      {.from = "*", .to = "leap", .when = {"jump"}},
                      {.from = "*", .to = "lie", .when = {"speed > 9"}}};
  MachineCrowd crowd(from);
  crowd.set(jump);
  EXPECT_EQ(crowd.current(), leap);
  crowd.step(3);
  crowd.set(hurt);
  EXPECT_EQ(crowd.current(), fall);
  EXPECT_EQ(crowd.channel().entered_at(), 3 * frame_ticks);
  crowd.step(3);
  EXPECT_EQ(crowd.channel().entered_at(), 3 * frame_ticks) << "it does not lead from its own state";
}

}  // namespace
}  // namespace throng::anim::state_machine_channel_test
