#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/agent/system_snapshot.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/counting/hot_path_counter.h"

// Agents, characters, channels and post processes come and go at frame boundaries.
namespace throng::anim::life_test {
namespace {

std::shared_ptr<const Character> character_of(int bones) {
  return std::make_shared<const Character>(bake_character(synthetic_model(bones, 3)));
}

std::unique_ptr<AnimationSystem> empty_system(const SystemOptions& options = {}) {
  return std::move(*AnimationSystem::create(test_character(), options));
}

AgentId spawn(AnimationSystem& system, int clip) {
  const AgentId agent = system.add_agent();
  EXPECT_TRUE(system.agent(agent).play({.clip = clip % 5, .start = ticks_per_second * clip / 7}));
  return agent;
}

void step(AnimationSystem& system) {
  system.advance(frame_ticks);
  std::vector<PoseRequest> updates;
  for (const AgentId agent : system.agents()) updates.push_back({.agent = agent});
  system.update(updates);
}

TEST(AgentLife, AnIdNamesItsAgentUntilThatIsRemoved) {
  const auto system = empty_system();
  const AgentId first = spawn(*system, 0);
  const AgentId second = spawn(*system, 1);
  EXPECT_TRUE(system->remove_agent(first));
  EXPECT_FALSE(system->agent(first).exists());
  EXPECT_TRUE(system->agent(second).exists());
  EXPECT_EQ(system->agent_count(), 1U);
  const AgentId third = spawn(*system, 2);
  EXPECT_EQ(third.number, first.number) << "numbers are used again";
  EXPECT_NE(third, first);
  EXPECT_FALSE(system->agent(first).exists());
  EXPECT_EQ(system->number_limit(), 2U);
}

TEST(AgentLife, AgentsAreListedInTheOrderInWhichTheyCame) {
  const auto system = empty_system();
  std::vector<AgentId> all;
  for (int i = 0; i < 6; ++i) all.push_back(spawn(*system, i));
  for (const int gone : {4, 1}) {
    system->remove_agent(all[static_cast<std::size_t>(gone)]);
    all.erase(all.begin() + gone);
  }
  all.push_back(spawn(*system, 6));
  const auto listed = system->agents();
  EXPECT_EQ(std::vector(listed.begin(), listed.end()), all);
}

// The same crowd, once among many that come and go in the same frame, and once alone.
TEST(AgentLife, PosesAndTheirHashDoNotDependOnWhoDiedBefore) {
  const auto quiet = empty_system();
  const auto busy = empty_system({.pus = 2});
  for (int i = 0; i < 40; ++i) {
    spawn(*quiet, i);
    const AgentId passing = spawn(*busy, 3 * i);
    const AgentId other = spawn(*busy, i + 1);
    busy->remove_agent(passing);
    spawn(*busy, i);
    busy->remove_agent(other);
  }
  for (int frame = 0; frame < 20; ++frame) {
    step(*quiet);
    step(*busy);
    ASSERT_EQ(busy->figures().pose_hash(), quiet->figures().pose_hash()) << "frame " << frame;
  }
}

TEST(AgentLife, ThePlaceOfAHashMovesUpWhenOneBeforeItDies) {
  const auto with = empty_system();
  const auto without = empty_system();
  const AgentId dies = with->add_agent();  // it is never updated
  for (const auto* system : {&with, &without}) {
    for (int i = 0; i < 3; ++i) spawn(**system, i);
  }
  const auto step_three = [](AnimationSystem& system) {
    system.advance(frame_ticks);
    std::vector<PoseRequest> updates;
    for (const AgentId agent : system.agents().last(3)) updates.push_back({.agent = agent});
    system.update(updates);
  };
  step_three(*with);
  step_three(*without);
  with->remove_agent(dies);
  const auto hash = [](const AnimationSystem& system, std::uint32_t number) {
    return system.figures().agent_hashes()[number];
  };
  for (const auto* system : {&with, &without}) (*system)->update({});
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(hash(*with, i + 1), hash(*without, i));
}

TEST(AgentLife, AFrameThatAddsAndRemovesAThousandAllocatesNothingAfterTheFirst) {
  constexpr int crowd = 1000;
  const auto system = empty_system({.trace = Tracing::off});
  std::vector<AgentId> living;
  living.reserve(2 * crowd);
  std::vector<PoseRequest> updates;
  updates.reserve(2 * crowd);
  const auto replace_all = [&] {
    for (const AgentId agent : living) system->remove_agent(agent);
    living.clear();
    for (int i = 0; i < crowd; ++i) living.push_back(system->add_agent());
    for (const AgentId agent : living) system->agent(agent).play({.clip = static_cast<int>(agent.number % 5)});
    system->advance(frame_ticks);
    updates.clear();
    for (const AgentId agent : living) updates.push_back({.agent = agent});
    system->update(updates);
  };
  for (int frame = 0; frame < 3; ++frame) replace_all();
  const HotPathCounts before = hot_path_counts();
  for (int frame = 0; frame < 5; ++frame) replace_all();
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
  EXPECT_EQ(system->agent_count(), static_cast<std::uint32_t>(crowd));
}

TEST(AgentLife, ALayerForWhichThereIsNoRoomPlaysNothing) {
  const auto system = empty_system({.local_store_bytes = std::size_t{16} << 10U});
  Agent agent = system->agent(system->add_agent());
  agent.play({.clip = 0});
  int played = 0;
  constexpr int layers = 40;
  for (int layer = 0; layer < layers; ++layer) {
    const Result<ChannelId> added = agent.add_channel(std::make_unique<CrossFadeChannel>());
    ASSERT_TRUE(added);
    if (agent.play(*added, {.clip = 1})) ++played;
    system->advance(frame_ticks);
    const PoseRequest update{.agent = agent.id()};
    system->update({&update, 1});
  }
  EXPECT_GT(played, 0);
  EXPECT_LT(played, layers) << "this many layers have no room";
}

TEST(CharacterLife, ASnapshotOfACharacterThatLeftIsRefusedThoughItCameBack) {
  const auto system = empty_system();
  const Result<CharacterId> guest = system->characters().add(test_character());
  ASSERT_TRUE(guest);
  system->agent(system->add_agent(*guest)).play({.clip = 1});
  SystemSnapshot snapshot;
  system->snapshot(snapshot);
  system->remove_agent(system->agents()[0]);
  ASSERT_TRUE(system->characters().remove(*guest));
  ASSERT_TRUE(system->characters().add(test_character()));
  EXPECT_FALSE(system->restore(snapshot)) << "its graphs are those of pools that are gone";
}

TEST(AgentLife, ASnapshotBringsTheDeadBackUnderTheirIds) {
  const auto system = empty_system();
  const AgentId first = spawn(*system, 0);
  const AgentId second = spawn(*system, 1);
  step(*system);
  SystemSnapshot snapshot;
  system->snapshot(snapshot);
  step(*system);
  const std::uint64_t both = system->figures().pose_hash();
  system->remove_agent(first);
  const AgentId third = spawn(*system, 4);
  ASSERT_TRUE(system->restore(snapshot));
  EXPECT_TRUE(system->agent(first).exists());
  EXPECT_TRUE(system->agent(second).exists());
  EXPECT_FALSE(system->agent(third).exists());
  step(*system);
  EXPECT_EQ(system->figures().pose_hash(), both);
}

TEST(ChannelLife, AnIdNamesItsChannelWhateverLiesBelow) {
  const auto system = empty_system();
  Agent agent = system->agent(spawn(*system, 0));
  const auto lower = agent.add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}));
  const auto upper = agent.add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 2}));
  ASSERT_TRUE(lower && upper);
  const SimpleChannel* const kept = agent.channel<SimpleChannel>(*upper);
  EXPECT_TRUE(agent.remove_channel(*lower));
  EXPECT_EQ(agent.channel<SimpleChannel>(*upper), kept);
  EXPECT_EQ(agent.channel(*lower), nullptr);
  const auto third = agent.add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}));
  ASSERT_TRUE(third);
  EXPECT_NE(*third, *lower) << "no number is used twice";
}

TEST(ChannelLife, AChannelIsGivenOutAsTheTypeThatItWasAddedAs) {
  const auto system = empty_system();
  Agent agent = system->agent(spawn(*system, 0));
  const auto added = agent.add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}));
  ASSERT_TRUE(added);
  EXPECT_NE(agent.channel(*added), nullptr);
  EXPECT_NE(agent.channel<SimpleChannel>(*added), nullptr);
  EXPECT_EQ(agent.channel<BlendSpaceChannel>(*added), nullptr);
}

TEST(ProcessLife, OneInTheMiddleIsRemovedAndTheOthersStay) {
  const auto system = empty_system();
  Agent agent = system->agent(spawn(*system, 0));
  std::array<ProcessId, 3> noises;
  for (ProcessId& noise : noises) {
    const auto added = agent.add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{}));
    ASSERT_TRUE(added);
    noise = *added;
  }
  EXPECT_TRUE(agent.remove_post_process(noises[1]));
  EXPECT_EQ(agent.post_process_count(), 2U);
  EXPECT_EQ(agent.post_process_id(0), noises[0]);
  EXPECT_EQ(agent.post_process_id(1), noises[2]);
  EXPECT_EQ(agent.program().steps.size(), 3U) << "the player and two noises";
  step(*system);
}

TEST(CharacterLife, LeavesWhenNobodyPlaysItAndItsNumberIsUsedAgain) {
  const auto system = empty_system();
  spawn(*system, 0);
  std::weak_ptr<const Character> lender;
  CharacterId guest;
  {
    const auto character = character_of(12);
    lender = character;
    guest = *system->characters().add(character);
  }
  const AgentId visitor = system->add_agent(guest);
  system->agent(visitor).play({.clip = 1});
  step(*system);
  const Status refused = system->characters().remove(guest);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("1 agents play"), std::string::npos) << refused.error().message;
  system->remove_agent(visitor);
  EXPECT_TRUE(system->characters().remove(guest));
  EXPECT_TRUE(lender.expired()) << "the system lets go of the character";
  const CharacterId next = *system->characters().add(character_of(20));
  EXPECT_EQ(next.number, guest.number);
  EXPECT_FALSE(system->characters().has(guest));
  EXPECT_TRUE(system->characters().has(next));
  const AgentId again = system->add_agent(next);
  system->agent(again).play({.clip = 2});
  step(*system);
}

TEST(CharacterLife, AHundredComeAndGoWhileOthersPlay) {
  const auto alone = empty_system();
  const auto host = empty_system();
  for (const auto* system : {&alone, &host}) spawn(**system, 3);
  const AgentId lasting = host->agents().front();
  const std::array characters{character_of(8), character_of(40), character_of(17)};
  for (std::size_t i = 0; i < 100; ++i) {
    const auto guest = host->characters().add(characters[i % characters.size()]);
    ASSERT_TRUE(guest) << guest.error().message;
    const AgentId visitor = host->add_agent(*guest);
    host->agent(visitor).play({.clip = static_cast<int>(i % 3)});
    step(*host);
    step(*alone);
    host->remove_agent(visitor);
    ASSERT_TRUE(host->characters().remove(*guest));
  }
  EXPECT_EQ(host->characters().count(), 1U);
  EXPECT_EQ(host->figures().agent_hashes()[lasting.number], alone->figures().agent_hashes()[0]);
}

}  // namespace
}  // namespace throng::anim::life_test
