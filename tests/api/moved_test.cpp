// What was moved from has nothing: its calls are misuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::moved_test {
namespace {

using anim::HeardMisuses;
using api_test::mannequin;
using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

Crowd made() { return std::move(*Crowd::create(mannequin())); }

TEST(Moved, EveryCallOfACrowdThatWasMovedFromIsAMisuse) {
  const HeardMisuses heard;
  Crowd from = made();
  const Crowd to = std::move(from);
  Snapshot snapshot;
  const PoseRequest request{.agent = {0}};
  EXPECT_FALSE(from.configure({.pus = 2}));
  EXPECT_FALSE(from.add(mannequin()));
  EXPECT_FALSE(from.remove(0));
  EXPECT_FALSE(from.replace(0, mannequin()));
  EXPECT_FALSE(from.character(0));
  EXPECT_EQ(from.palette_bytes(0), 0U);
  EXPECT_FALSE(from.write_joints(0, {}));
  EXPECT_EQ(from.joint_bytes(0), 0U);
  EXPECT_FALSE(from.add_mask(0, {}).valid());
  EXPECT_FALSE(from.add_step(0, {}));
  EXPECT_FALSE(from.add_agent().valid());
  EXPECT_TRUE(from.add_agents(3).empty());
  EXPECT_FALSE(from.remove_agent({0}));
  EXPECT_FALSE(from.agent({0}).exists());
  EXPECT_TRUE(from.agents().empty());
  EXPECT_EQ(from.number_limit(), 0U);
  from.advance(ticks_per_second);
  EXPECT_EQ(from.clock(), Ticks{});
  from.update({&request, 1});
  from.pose_exactly({&request, 1});
  EXPECT_FALSE(from.local_pose({0}, {}));
  from.snapshot(snapshot);
  EXPECT_FALSE(from.restore(snapshot));
  EXPECT_EQ(from.debug().posed_agents(), 0U);
  EXPECT_EQ(HeardMisuses::all().size(), 24U) << "one a call";
  EXPECT_THAT(HeardMisuses::all(), Each(AllOf(HasSubstr("Crowd::"), HasSubstr("it was moved from"))));
  EXPECT_EQ(from.configure({}).error().message, "Crowd::configure: it was moved from");
}

TEST(Moved, AnAgentOfACrowdThatWasMovedFromIsNoAgent) {
  const HeardMisuses heard;
  Crowd from = made();
  const Crowd to = std::move(from);
  const Agent nobody = from.agent({0});
  EXPECT_FALSE(nobody.play({.clip = {0}}));
  EXPECT_FALSE(nobody.add_clips());
  EXPECT_FALSE(nobody.add_slot());
  EXPECT_FALSE(nobody.add(LookAt{}));
  EXPECT_FALSE(nobody.set_speed(2.0));
  EXPECT_FALSE(nobody.processes().look_at({0}, {}));
  EXPECT_FALSE(Machine(nobody, {0}).set(0, 1.0F));
  EXPECT_EQ(nobody.motion().displacement({}, {}).turn, 0.0F);
  EXPECT_GE(HeardMisuses::all().size(), 8U);
}

TEST(Moved, AgentsOfACrowdGoWithIt) {
  Crowd from = made();
  const Agent agent = from.agent(from.add_agent());
  Crowd to = std::move(from);
  EXPECT_TRUE(agent.play({.clip = {1}}));
  from = std::move(to);
  EXPECT_EQ(from.agents().size(), 1U) << "what was moved from takes another crowd";
}

TEST(Moved, EveryCallOfALodThatWasMovedFromIsAMisuse) {
  const HeardMisuses heard;
  Crowd crowd = made();
  crowd.add_agents(2);
  const std::vector<Vec3> positions(2);
  Lod from;
  EXPECT_EQ(from.select(crowd, {.positions = positions}).size(), 2U);
  Lod to = std::move(from);
  EXPECT_TRUE(from.select(crowd, {.positions = positions}).empty());
  EXPECT_TRUE(from.requests().empty());
  from.settle(crowd);
  from.make_due({0});
  EXPECT_FALSE(from.is_visible({0}));
  EXPECT_EQ(HeardMisuses::all().size(), 5U);
  EXPECT_THAT(HeardMisuses::all(), Each(AllOf(HasSubstr("Lod::"), HasSubstr("it was moved from"))));
  const Crowd other = std::move(crowd);
  EXPECT_TRUE(to.select(crowd, {.positions = positions}).empty()) << "nor has a crowd that was moved from any agents";
}

TEST(Moved, EveryCallOfABuilderThatWasMovedFromIsAMisuse) {
  const HeardMisuses heard;
  CharacterBuilder from("person");
  const CharacterBuilder to = std::move(from);
  EXPECT_EQ(from.add_bone({.name = "root"}), -1);
  EXPECT_EQ(from.add_clip("walk", 1.0), -1);
  from.set_translations(0, 0, {});
  from.set_rotations(0, 0, {});
  from.set_scales(0, 0, {});
  from.add_data_key(0, "key", 0.0);
  from.add_curve(0, "curve", {}, {});
  from.add_mesh({});
  EXPECT_FALSE(from.build());
  EXPECT_EQ(HeardMisuses::all().size(), 9U) << "one a call";
  EXPECT_THAT(HeardMisuses::all(), Each(AllOf(HasSubstr("CharacterBuilder::"), HasSubstr("it was moved from"))));
}

TEST(Moved, OtherValuesThatWereMovedFromAreEmpty) {
  const HeardMisuses heard;
  Crowd crowd = made();
  Snapshot snapshot;
  crowd.snapshot(snapshot);
  Snapshot kept = std::move(snapshot);
  EXPECT_EQ(snapshot.bytes(), 0U);
  EXPECT_EQ(crowd.restore(snapshot).error().message, "Crowd::restore: the snapshot was moved from");
  Character character = mannequin();
  const Character other = std::move(character);
  EXPECT_EQ(character.clip_count(), 0U);
  EXPECT_FALSE(Crowd::create(character));
  EXPECT_FALSE(StateMachine::parse("{}", character));
  StateMachine machine;
  EXPECT_FALSE(crowd.agent(crowd.add_agent()).add(std::move(machine)));
  EXPECT_FALSE(machine.find_input("speed"));
}

}  // namespace
}  // namespace throng::moved_test
