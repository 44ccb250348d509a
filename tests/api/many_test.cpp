// Requests to many agents at a time.

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::many_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint32_t agents = 700;  // more than one job

/// A crowd whose agents walk in a blend space, look, and stand on a ground.
struct Walkers {
  ApiCrowd crowd;
  std::vector<ChannelId> gaits;
  std::vector<ProcessId> gazes, feet, sockets;

  explicit Walkers(int pus) : crowd(agents, {.pus = pus}) {
    std::vector<BlendPoint> points{{.clip = mannequin().find_clip("idle")}};
    for (const char* gait : {"walk", "jog", "run"}) {
      const ClipId clip = mannequin().find_clip(gait);
      points.push_back({.clip = clip, .parameter = static_cast<float>(mannequin().clip(clip).ground_speed)});
    }
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const Agent own = crowd.agent(agent);
      gaits.push_back(*own.add(BlendSpace{.points = points, .parameter = 0.1F * static_cast<float>(agent % 37)}));
      gazes.push_back(*own.add(LookAt{}));
      feet.push_back(*own.add(FootPlacement{}));
      sockets.push_back(*own.add(Socket{.bone = 5}));
    }
    crowd.step(3);
  }
};

float speed_of(std::uint32_t agent, int frame) {
  return 0.09F * static_cast<float>((agent * 7 + static_cast<std::uint32_t>(frame) * 5) % 43);
}
Vec3 target_of(std::uint32_t agent, int frame) {
  return {0.1F * static_cast<float>(agent % 9), 1.5F, 2.0F - 0.1F * static_cast<float>(frame)};
}
Place place_of(std::uint32_t agent, int frame) {
  return {.position = {static_cast<float>(agent), 0.0F, 0.02F * static_cast<float>(frame)}};
}
Vec3 ground_of(std::uint32_t agent) { return {static_cast<float>(agent), 0.01F * static_cast<float>(agent % 5), 0.0F}; }

TEST(ManyAgents, ArePosedAsIfEachWereAskedAlone) {
  Walkers together(2), alone(1);
  std::vector<ParameterRequest> speeds;
  std::vector<GazeRequest> gazes;
  std::vector<PlacementRequest> places;
  std::vector<GroundRequest> grounds;
  for (int frame = 0; frame < 30; ++frame) {
    speeds.clear(), gazes.clear(), places.clear(), grounds.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const Agent own = alone.crowd.agent(agent);
      own.set_parameter(alone.gaits[agent], speed_of(agent, frame));
      own.processes().look_at(alone.gazes[agent], target_of(agent, frame), ticks_per_second / 5);
      own.processes().set_placement(alone.feet[agent], place_of(agent, frame));
      own.processes().set_ground(alone.feet[agent], -1, ground_of(agent), {0.0F, 1.0F, 0.0F});
      speeds.push_back({.agent = {agent}, .channel = together.gaits[agent], .x = speed_of(agent, frame)});
      gazes.push_back({.agent = {agent},
                       .gaze = together.gazes[agent],
                       .target = target_of(agent, frame),
                       .fade = ticks_per_second / 5});
      places.push_back({.agent = {agent}, .process = together.feet[agent], .model_in_world = place_of(agent, frame)});
      grounds.push_back({.agent = {agent}, .feet = together.feet[agent], .point = ground_of(agent)});
    }
    const ManyAgents many = together.crowd->many();
    EXPECT_TRUE(many.set_parameters(speeds) && many.look_at(gazes));
    EXPECT_TRUE(many.set_placements(places) && many.set_grounds(grounds));
    together.crowd.step();
    alone.crowd.step();
    ASSERT_EQ(together.crowd.hash(), alone.crowd.hash()) << "frame " << frame;
  }
}

TEST(ManyAgents, MoveOnAPlaneAtBothParametersAsOneDoes) {
  ApiCrowd crowd(2);
  const ClipId walk = mannequin().find_clip("walk");
  const auto speed = static_cast<float>(mannequin().clip(walk).ground_speed);
  const BlendPoint2d points[] = {{.clip = mannequin().find_clip("idle")}, {.clip = walk, .y = speed}};
  const auto one = crowd.agent(0).add(BlendSpace2d{.points = points});
  const auto other = crowd.agent(1).add(BlendSpace2d{.points = points});
  ASSERT_TRUE(one && other);
  const ParameterRequest request{.agent = {1}, .channel = *other, .x = 0.0F, .y = 0.5F * speed};
  EXPECT_TRUE(crowd.agent(0).set_parameters(*one, 0.0F, 0.5F * speed));
  EXPECT_TRUE(crowd->many().set_parameters({&request, 1}));
  crowd.step(60);
  const Ticks before = crowd->clock();
  crowd.step(60);
  std::array<RootMotion, 2> ways;
  EXPECT_TRUE(crowd->many().displacements(before, crowd->clock(), crowd->agents(), ways));
  for (const RootMotion& way : ways) EXPECT_NEAR(way.displacement.z, 0.5F * speed, 0.02F);
}

TEST(ManyAgents, TakeTheLastOfTwoRequestsToAnAgent) {
  Walkers twice(2), once(1);
  const std::array both{ParameterRequest{{3}, twice.gaits[3], 3.4F}, ParameterRequest{{3}, twice.gaits[3], 0.3F}};
  EXPECT_TRUE(twice.crowd->many().set_parameters(both));
  for (const float speed : {3.4F, 0.3F}) once.crowd.agent(3).set_parameter(once.gaits[3], speed);
  twice.crowd.step();
  once.crowd.step();
  EXPECT_EQ(twice.crowd.hash(), once.crowd.hash());
}

TEST(ManyAgents, TakeTheLegsOfAnAgentOneAfterTheOther) {
  Walkers together(2), alone(1);
  std::vector<GroundRequest> grounds;
  for (int frame = 0; frame < 10; ++frame) {
    grounds.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      for (const int leg : {0, 1, 0}) {
        const Vec3 point{0.0F, 0.02F * static_cast<float>(static_cast<int>(grounds.size()) % 7 + leg), 0.0F};
        alone.crowd.agent(agent).processes().set_ground(alone.feet[agent], leg, point, {0.0F, 1.0F, 0.0F});
        grounds.push_back({.agent = {agent}, .feet = together.feet[agent], .leg = leg, .point = point});
      }
    }
    EXPECT_TRUE(together.crowd->many().set_grounds(grounds));
    together.crowd.step();
    alone.crowd.step();
    ASSERT_EQ(together.crowd.hash(), alone.crowd.hash()) << "frame " << frame;
  }
}

TEST(ManyAgents, LeaveOutWhatCannotBeMetAndReportItOnce) {
  const HeardMisuses heard;
  Walkers some(2), good(1);
  some.crowd->remove_agent({1});
  good.crowd->remove_agent({1});
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::array requests{ParameterRequest{{0}, some.gaits[0], 2.0F}, ParameterRequest{{1}, some.gaits[1], 2.0F},
                            ParameterRequest{{2}, some.gaits[2], nan}, ParameterRequest{{3}, ChannelId{77}, 2.0F},
                            ParameterRequest{{agents + 5}, some.gaits[0], 2.0F}};
  EXPECT_FALSE(some.crowd->many().set_parameters(requests));
  ASSERT_EQ(HeardMisuses::all().size(), 1U);
  EXPECT_THAT(HeardMisuses::all().front(), HasSubstr("ManyAgents::set_parameters"));
  good.crowd.agent(0).set_parameter(good.gaits[0], 2.0F);
  some.crowd.step();
  good.crowd.step();
  EXPECT_EQ(some.crowd.hash(), good.crowd.hash());
}

TEST(ManyAgents, LeaveAnAgentAloneThatHasTheNumberOfAnAgentThatIsGone) {
  const HeardMisuses heard;
  ApiCrowd crowd(2);
  const AgentId gone = crowd->agents()[1];
  crowd->remove_agent(gone);
  const AgentId next = crowd->add_agent();
  ASSERT_EQ(next.number, gone.number);
  crowd->agent(next).play({.clip = mannequin().find_clip("walk")});
  const SpeedRequest late{.agent = gone, .speed = 2.0F};
  EXPECT_FALSE(crowd->many().set_speeds({&late, 1}));
  RootMotion way;
  crowd->advance(ticks_per_second);
  EXPECT_TRUE(crowd->many().displacements({}, ticks_per_second, {&next, 1}, {&way, 1}));
  EXPECT_NEAR(way.displacement.z, mannequin().clip(mannequin().find_clip("walk")).ground_speed, 0.05);
}

TEST(ManyAgents, TellHowTheyMoveAsEachDoesAlone) {
  Walkers walkers(2);
  const Ticks before = walkers.crowd->clock();
  walkers.crowd.step(40);
  const Ticks now = walkers.crowd->clock();
  const std::vector<AgentId> all(walkers.crowd->agents().begin(), walkers.crowd->agents().end());
  std::vector<RootMotion> ways(agents);
  std::vector<Place> places(agents);
  std::vector<ProcessOf> sockets;
  sockets.reserve(agents);
  for (const AgentId agent : all) sockets.push_back({.agent = agent, .process = walkers.sockets[agent.number]});
  ASSERT_TRUE(walkers.crowd->many().displacements(before, now, all, ways));
  ASSERT_TRUE(walkers.crowd->many().sockets(sockets, places));
  const auto keys = walkers.crowd->many().keys(before, now, all);
  ASSERT_GT(keys.size(), agents / 2);
  std::size_t next = 0;
  for (const AgentId agent : all) {
    const Agent own = walkers.crowd->agent(agent);
    EXPECT_EQ(own.motion().displacement(before, now).displacement, ways[agent.number].displacement);
    EXPECT_EQ(own.processes().socket(walkers.sockets[agent.number]).position, places[agent.number].position);
    EXPECT_EQ(own.processes().socket(walkers.sockets[agent.number]).rotation, places[agent.number].rotation);
    own.motion().for_each_key(before, now, [&](const DataKey& key) {
      ASSERT_LT(next, keys.size());
      EXPECT_EQ(keys[next].agent, agent);
      EXPECT_EQ(keys[next++].key.time, key.time);
    });
  }
  EXPECT_EQ(next, keys.size());
  EXPECT_LT(walkers.crowd->many().keys(before, now, all, KeyChoice::heaviest).size(), next)
      << "some stand more than walk";
}

TEST(ManyAgents, SayThatAnAgentIsGoneAndAnswerForTheOthers) {
  const HeardMisuses heard;
  Walkers walkers(2);
  const Ticks before = walkers.crowd->clock();
  walkers.crowd.step(40);
  walkers.crowd->remove_agent({1});
  const std::array ids{AgentId{0}, AgentId{1}, AgentId{36}};
  std::array<RootMotion, 3> ways;
  EXPECT_FALSE(walkers.crowd->many().displacements(before, walkers.crowd->clock(), ids, ways));
  EXPECT_EQ(ways[1].displacement, Vec3{});
  EXPECT_GT(ways[2].displacement.z, 1.0F);
  EXPECT_FALSE(walkers.crowd->many().keys(before, walkers.crowd->clock(), ids).empty());
  EXPECT_THAT(HeardMisuses::all(), ElementsAre(HasSubstr("ManyAgents::displacements: an agent of this id"),
                                               HasSubstr("ManyAgents::keys: an agent of this id")));
}

TEST(ManyAgents, TellTheirTurnsToo) {
  CharacterBuilder builder("dancer");
  builder.add_bone({.name = "hips", .rest = {.translation = {0.0F, 1.0F, 0.0F}}});
  const float seconds[] = {0.0F, 1.0F}, half = std::sqrt(0.5F);
  const Quat turns[] = {{}, {.y = half, .w = half}};
  const Vec3 places[] = {{0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 2.0F}};
  const int clip = builder.add_clip("turn", 1.0);
  builder.set_rotations(clip, 0, {.seconds = seconds, .values = turns});
  builder.set_translations(clip, 0, {.seconds = seconds, .values = places});
  Crowd crowd = std::move(*Crowd::create(builder.build()->characters.front()));
  const AgentId agent = crowd.add_agent();
  crowd.agent(agent).play({.clip = {0}, .loop = false});
  crowd.advance(ticks_per_second);
  RootMotion way;
  EXPECT_TRUE(crowd.many().displacements({}, ticks_per_second, {&agent, 1}, {&way, 1}));
  EXPECT_NEAR(way.turn, 2.0F * std::atan2(half, half), 0.01F);
}

TEST(ManyAgents, RefuseAnswersWithoutRoomTimesFarOffAndSocketsThatThereAreNot) {
  const HeardMisuses heard;
  Walkers walkers(1);
  const std::array ids{AgentId{0}, AgentId{1}};
  std::array<RootMotion, 1> short_of_one;
  EXPECT_FALSE(walkers.crowd->many().displacements({}, {}, ids, short_of_one));
  std::array<RootMotion, 2> ways;
  EXPECT_FALSE(walkers.crowd->many().displacements(ticks_per_second * -100'000, {}, ids, ways));
  EXPECT_TRUE(walkers.crowd->many().keys({}, ticks_per_second * 61, ids).empty());
  const ProcessOf gaze{.agent = {0}, .process = walkers.gazes[0]};
  std::array<Place, 1> place;
  EXPECT_FALSE(walkers.crowd->many().sockets({&gaze, 1}, place));
  EXPECT_THAT(HeardMisuses::all(), ElementsAre(HasSubstr("ManyAgents::displacements: there is no room"),
                                               HasSubstr("ManyAgents::displacements: times are within a day"),
                                               HasSubstr("ManyAgents::keys: an interval is a minute at most"),
                                               HasSubstr("ManyAgents::sockets: an agent has no socket")));
}

}  // namespace
}  // namespace throng::many_test
