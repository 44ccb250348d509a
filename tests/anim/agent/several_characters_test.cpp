// Several skeletons in one system: a mixed crowd, and a cut scene of agents, a camera and a prop (paper 2: "characters,
// cameras, animated backgrounds").

#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::several_characters_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr std::array<int, 3> bone_counts = {62, 2, 20};

std::shared_ptr<const Character> character_of(int bones) {
  return std::make_shared<const Character>(bake_character(synthetic_model(bones, 3)));
}

/// One palette an agent, in memory of the test's own.
struct Palettes {
  explicit Palettes(std::size_t agents) {
    for (std::size_t i = 0; i < agents; ++i) memory.push_back(allocate_aligned(64 * sizeof(PaletteMatrix)));
  }
  std::byte* of(std::size_t agent) { return memory[agent].get(); }
  std::vector<AlignedBytes> memory;
};

void run(AnimationSystem& system, Palettes& palettes, int frames) {
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < system.agent_count(); ++agent) {
    updates.push_back({.agent = {agent}, .palette = palettes.of(agent)});
  }
  for (int i = 0; i < frames; ++i) {
    system.advance(frame);
    system.update(updates);
  }
}

void play(AnimationSystem& system, std::uint32_t agent, int seed) {
  system.agent(agent).play({.clip = seed % 3, .speed = 0.8 + 0.1 * (seed % 5)});
  if (seed % 2 == 0) system.agent(agent).play({.clip = (seed + 1) % 3, .fade = 20 * frame});
}

std::unique_ptr<AnimationSystem> mixed_crowd(const SystemOptions& options, std::uint32_t agents_of_each) {
  auto system = std::move(*AnimationSystem::create(character_of(bone_counts[0]), options));
  EXPECT_EQ(system->characters().add(character_of(bone_counts[1]))->number, 1U);
  EXPECT_EQ(system->characters().add(character_of(bone_counts[2]))->number, 2U);
  for (std::uint32_t i = 0; i < agents_of_each; ++i) {
    for (std::uint32_t character = 0; character < bone_counts.size(); ++character) {
      const std::uint32_t agent = system->add_agent(character).number;
      play(*system, agent, static_cast<int>(i));
    }
  }
  return system;
}

TEST(SeveralCharacters, MoveInOneSystemAsInSystemsOfTheirOwn) {
  constexpr std::uint32_t each = 19;
  Palettes mixed(3 * each);
  run(*mixed_crowd({.pus = 2}, each), mixed, 15);
  for (std::uint32_t character = 0; character < bone_counts.size(); ++character) {
    auto alone = std::move(*AnimationSystem::create(character_of(bone_counts[character]), {}));
    alone->set_agent_count(each);
    for (std::uint32_t agent = 0; agent < each; ++agent) play(*alone, agent, static_cast<int>(agent));
    Palettes own(each);
    run(*alone, own, 15);
    const std::size_t bytes = static_cast<std::size_t>(bone_counts[character]) * sizeof(PaletteMatrix);
    for (std::uint32_t agent = 0; agent < each; ++agent) {
      EXPECT_EQ(std::memcmp(mixed.of(3 * agent + character), own.of(agent), bytes), 0)
          << bone_counts[character] << " bones, agent " << agent;
    }
  }
}

TEST(SeveralCharacters, HaveOneHashUnderEveryScheduleTileAndNumberOfPus) {
  const auto hash = [](const SystemOptions& options) {
    const auto system = mixed_crowd(options, 13);
    Palettes palettes(system->agent_count());
    run(*system, palettes, 12);
    return system->figures().pose_hash();
  };
  const std::uint64_t expected = hash({});
  EXPECT_EQ(hash({.schedule = Schedule::levels}), expected);
  EXPECT_EQ(hash({.pus = 3, .tile = 4}), expected);
  EXPECT_EQ(hash({.pus = 2, .tile = 1, .schedule = Schedule::levels}), expected);
  EXPECT_EQ(hash({.local_store_bytes = 16 * 1024, .double_buffering = DoubleBuffering::off}), expected);
}

TEST(SeveralCharacters, AreRefusedWhereTheLocalStoreIsTooSmallForOneAndNothingHasChanged) {
  auto system = std::move(*AnimationSystem::create(character_of(20), {.local_store_bytes = 8 * 1024}));
  system->set_agent_count(1);
  system->agent(0).play({.clip = 0});
  const auto added = system->characters().add(character_of(900));
  ASSERT_FALSE(added.has_value());
  EXPECT_NE(added.error().message.find("local store"), std::string::npos) << added.error().message;
  Palettes palettes(1);
  run(*system, palettes, 2);
}

// A clip with no sampled stream needs larger players, but only in the tiles of its own character.
TEST(SeveralCharacters, OneThatPlaysFromKeysDoesNotNarrowTheTilesOfTheOthers) {
  const SystemOptions options{.local_store_bytes = 64 * 1024, .tile = 16};
  auto system = std::move(*AnimationSystem::create(character_of(62), options));
  Character steps = bake_character(synthetic_model(1, 1));
  steps.clips[0].sampled_block = nullptr;
  const auto added = system->characters().add(std::make_shared<const Character>(std::move(steps)));
  ASSERT_TRUE(added.has_value()) << added.error().message;
  EXPECT_EQ(system->figures().schedule().plan.width, 16);
}

TEST(SeveralCharacters, BeyondWhatASystemAnimatesAreRefused) {
  auto system = std::move(*AnimationSystem::create(character_of(2), {}));
  for (std::uint32_t number = 1; number < most_skeletons; ++number) {
    ASSERT_TRUE(system->characters().add(character_of(2)).has_value()) << number;
  }
  const auto added = system->characters().add(character_of(2));
  ASSERT_FALSE(added.has_value());
  EXPECT_NE(added.error().message.find("at most 32"), std::string::npos) << added.error().message;
}

// Everybody in a cut scene is placed by the scene: the same point of the world, from which each moves on by its own
// clip's root motion.
TEST(CutScene, PlacesAgentsACameraAndAPropByTheirAbsoluteRoots) {
  Character walker = bake_character(synthetic_model(62, 1));
  const Ticks duration = walker.clips[0].duration;
  walker.clips[0].root_motion = straight_root_curve(duration, {0.0, 0.0, 2.0});
  auto system = std::move(*AnimationSystem::create(std::make_shared<const Character>(std::move(walker)), {}));
  const CharacterId camera_kind = *system->characters().add(character_of(2));
  const CharacterId prop_kind = *system->characters().add(character_of(20));
  const std::uint32_t actor = system->add_agent().number;
  const std::uint32_t camera = system->add_agent(camera_kind).number;
  const std::uint32_t prop = system->add_agent(prop_kind).number;
  const std::uint32_t bystander = system->add_agent().number;

  const AbsoluteRoot scene{.position = {10.0, 0.5, -3.0},
                           .rotation = glm::angleAxis(glm::half_pi<float>(), glm::vec3(0.0F, 1.0F, 0.0F))};
  for (const std::uint32_t agent : {actor, camera, prop}) {
    system->agent(agent).play({.clip = 0, .loop = false, .absolute_root = scene});
  }
  system->agent(bystander).play({.clip = 0});

  Palettes palettes(4);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < 4; ++agent)
    updates.push_back({.agent = {agent}, .palette = palettes.of(agent)});
  system->advance(duration / 2);
  system->update(updates);
  const auto actor_root = system->agent(actor).motion().absolute_root(system->clock());
  ASSERT_TRUE(actor_root.has_value());
  EXPECT_NEAR(actor_root->position.x, 11.0, 1e-6) << "half of two metres, turned from +Z to +X";
  EXPECT_NEAR(actor_root->position.z, -3.0, 1e-6);
  for (const std::uint32_t agent : {camera, prop}) {
    const auto root = system->agent(agent).motion().absolute_root(system->clock());
    ASSERT_TRUE(root.has_value());
    EXPECT_EQ(root->position, scene.position) << "its clip moves bones, not the root";
  }
  EXPECT_FALSE(system->agent(bystander).motion().absolute_root(system->clock()).has_value());

  system->advance(10 * duration);
  EXPECT_NEAR(system->agent(actor).motion().absolute_root(system->clock())->position.x, 12.0, 1e-6)
      << "the scene holds its end";
}

}  // namespace
}  // namespace throng::anim::several_characters_test
