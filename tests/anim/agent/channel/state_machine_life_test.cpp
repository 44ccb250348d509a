// A state machine whatever comes: skipped frames, interruptions, snapshots, other layers, small stores, misuse.

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/channel/state_machine_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/channel/machine_crowd.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::anim::state_machine_life_test {
namespace {

using namespace machine_crowd;

/// A crowd that plays a clip as it is at a time of it after the next step.
CrowdRig playing(const PlayRequest& request) {
  CrowdRig crowd;
  crowd->agent(0).play(request);
  return crowd;
}

/// Two crowds that are told the same. One is posed in each frame, the other now and then.
struct Pair {
  MachineCrowd each_frame, seldom;

  void set(std::uint32_t input, float value) {
    each_frame.set(input, value);
    seldom.set(input, value);
  }
  void step(int frames) {
    each_frame.step(frames);
    seldom->advance((frames - 1) * frame_ticks);
    seldom.step();
  }
};

TEST(StateMachineLife, DoesNotDependOnWhichFramesArePosed) {
  Pair pair;
  for (int round = 0; round < 60; ++round) {
    if (round % 10 == 1) pair.set(jump, 1.0F);
    if (round % 20 == 12) pair.set(hurt, 1.0F);
    if (round % 20 == 16) pair.set(hurt, 0.0F);
    pair.step(30);  // longer than a fade
    ASSERT_EQ(pair.each_frame.current(), pair.seldom.current()) << round;
    ASSERT_EQ(pair.each_frame.channel().entered_at(), pair.seldom.channel().entered_at()) << round;
    ASSERT_TRUE(pair.each_frame.bones_unlike(pair.seldom).empty()) << round;
  }
}

TEST(StateMachineLife, MakesUpForAllThatWasMissed) {
  Pair pair;
  pair.set(hurt, 1.0F);
  pair.each_frame.step(2);
  pair.seldom->advance(2 * frame_ticks);
  pair.set(hurt, 0.0F);
  pair.step(1000);  // it fell, lay and got up
  EXPECT_EQ(pair.seldom.current(), move);
  EXPECT_TRUE(pair.each_frame.bones_unlike(pair.seldom).empty());
}

/// Leaps and is hurt now and then, and returns the farthest step of a joint from frame to frame.
float largest_step(int frames_between, double seconds) {
  MachineDescription from = description();
  from.transitions = {{.from = "*", .to = "leap", .when = {"speed >= 3"}, .fade = seconds},
                      {.from = "*", .to = "fall", .when = {"speed >= 2", "speed < 3"}, .fade = seconds},
                      {.from = "*", .to = "lie", .when = {"speed >= 1", "speed < 2"}, .fade = seconds},
                      {.from = "*", .to = "move", .when = {"speed < 1"}, .fade = seconds}};
  MachineCrowd crowd(from);
  float largest = 0.0F;
  std::vector<glm::vec3> before;
  for (int frame = 0; frame < 200; ++frame) {
    if (frame % frames_between == 0) crowd.set(speed, static_cast<float>(frame / frames_between % 4));
    crowd.step();
    const std::vector<glm::vec3> now = crowd.joints();
    for (std::size_t i = 0; i < before.size(); ++i) largest = std::max(largest, glm::distance(now[i], before[i]));
    before = now;
  }
  return largest;
}

TEST(StateMachineLife, ATransitionThatInterruptsAFadeDoesNotSnap) {
  const float calm = std::max(largest_step(23, fade), largest_step(30, fade));  // these fades are over before
  for (const int frames_between : {1, 2, 5, 11}) {
    EXPECT_LT(largest_step(frames_between, fade), 1.2F * calm) << "every " << frames_between << " frames";
  }
  EXPECT_GT(largest_step(5, 0.0), 1.2F * calm) << "else the promise above could not be broken";
}

TEST(StateMachineLife, LeavesNoEntityBehind) {
  MachineCrowd crowd;
  for (int i = 0; i < 100; ++i) {
    crowd.set(i % 3 == 0 ? jump : hurt, static_cast<float>(i % 2));
    crowd.step(i % 9);
    EXPECT_LE(crowd.entities(), 10U);
  }
  crowd.set(hurt, 0.0F);
  crowd.step(1000);
  EXPECT_EQ(crowd.entities(), 1U);
  crowd->agent(0).remove_channel(first);
  const EntityPools& pools = crowd->characters().pools(0);
  for (const auto kind : {EntityPools::ease_blenders, EntityPools::inertialisers, EntityPools::sampled_players}) {
    EXPECT_EQ(pools.pool(kind).alive_count(), 0U) << kind;
  }
}

TEST(StateMachineLife, GoesOnAfterASnapshot) {
  MachineCrowd crowd;
  crowd.set(jump);
  crowd.step(5);
  crowd.set(hurt);
  crowd.step(1);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(100);
  const std::uint64_t hash = crowd->figures().pose_hash();
  ASSERT_TRUE(crowd->restore(snapshot));
  EXPECT_EQ(crowd.current(), fall);
  crowd.step(100);
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
}

TEST(StateMachineLife, LiesOverOtherChannelsWithAMask) {
  CrowdRig crowd = playing({.clip = 0}), plain = playing({.clip = 0});
  const SubtreeWeight chest{.bone = 1};
  const BoneMask upper("upper body", test_character()->skeleton, {&chest, 1});
  const int mask = crowd->characters().add_mask(BoneMask("upper body", test_character()->skeleton, {&chest, 1}));
  ASSERT_TRUE(
      crowd->agent(0).add_channel(std::make_unique<StateMachineChannel>(machine_of(description())), {.mask = mask}));
  const auto hurt_it = [](StateMachineChannel& own) { own.set(hurt, 1.0F); };
  ASSERT_TRUE(crowd->agent(0).change<StateMachineChannel>({1}, hurt_it));
  for (CrowdRig* one : {&crowd, &plain}) one->step(30);
  EXPECT_FALSE(crowd.bones_unlike(plain).empty());
  for (const int bone : crowd.bones_unlike(plain)) EXPECT_GT(upper.weight(bone), 0.0F) << bone;
}

TEST(StateMachineLife, ShowsATransitionWithoutAFadeWhereALocalStoreHasNoRoomForOne) {
  MachineDescription from = description();
  from.states[0] = {.name = "move", .clip = "clip_0"};
  MachineCrowd crowd(from, {.local_store_bytes = std::size_t{16} << 10U});
  const auto lay_one_more = [&] {
    return crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1})).has_value();
  };
  while (lay_one_more()) {
  }
  const std::size_t full = crowd.entities();
  crowd.set(jump);
  crowd.step();
  EXPECT_EQ(crowd.current(), leap);
  EXPECT_EQ(crowd.entities(), full);
  crowd.step(frames_to(duration_of(2)));
  EXPECT_EQ(crowd.current(), move) << "by itself, too";
  EXPECT_EQ(crowd.entities(), full);
}

TEST(StateMachineLife, RefusesInputsThatThereAreNotAndNumbersThatAreNone) {
  const HeardMisuses heard;
  MachineCrowd crowd;
  crowd.set(3);
  crowd.set(speed, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(HeardMisuses::all().size(), 2U);
  EXPECT_EQ(crowd.channel().input(speed), 0.0F);
}

TEST(StateMachineLife, IsRefusedByACharacterThatHasNotItsClips) {
  const HeardMisuses heard;
  const auto other = std::make_shared<const Character>(bake_character(synthetic_model(40, 2)));
  const auto system = std::move(*AnimationSystem::create(other, {}));
  system->set_agent_count(1);
  const auto added = system->agent(0).add_channel(std::make_unique<StateMachineChannel>(machine_of(description())));
  ASSERT_FALSE(added);
  EXPECT_NE(added.error().message.find("plays a clip that the character has not"), std::string::npos);
  EXPECT_FALSE(system->agent(0).add_channel(std::make_unique<StateMachineChannel>(nullptr)));
}

TEST(StateMachineLife, AllocatesNothingInAFrame) {
  MachineCrowd crowd;
  const PoseRequest update{.agent = {0}};
  const auto live = [&] {
    const HotPathCounts before = hot_path_counts();
    for (int frame = 0; frame < 600; ++frame) {
      if (frame % 100 == 0) crowd.set(jump);
      if (frame % 100 == 10) crowd.set(hurt);
      if (frame % 100 == 60) crowd.set(hurt, 0.0F);
      crowd->advance(frame_ticks);
      crowd->update({&update, 1});
    }
    return (hot_path_counts() - before).allocations;
  };
  live();
  EXPECT_EQ(live(), 0U);
}

}  // namespace
}  // namespace throng::anim::state_machine_life_test
