#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::fades_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

struct Crowd {
  explicit Crowd(const SystemOptions& options = {}) {
    static const auto character = std::make_shared<const Character>(bake_character(synthetic_model(30, 4)));
    system = std::move(*AnimationSystem::create(character, options));
    system->set_agent_count(1);
  }
  void step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      system->advance(frame);
      const PoseRequest update{.agent = {0}};
      system->update({&update, 1});
    }
  }
  /// Of players and blenders, whose updates read what changes and nothing else.
  std::uint64_t fetched_blocks() const {
    return system->figures().report().copies.bytes_in / (entity_header_bytes - identity_bytes);
  }
  std::size_t entities() const { return system->agent(0).program().steps.size(); }
  std::unique_ptr<AnimationSystem> system;
};

TEST(Fade, TakesTwoPlayersAndABlenderWhileItRunsAndOnePlayerAfterwards) {
  Crowd crowd;
  crowd.system->agent(0).play({.clip = 0});
  crowd.step();
  EXPECT_EQ(crowd.fetched_blocks(), 1U);
  crowd.system->agent(0).play({.clip = 1, .fade = 10 * frame});
  crowd.step(9);
  EXPECT_EQ(crowd.fetched_blocks(), 3U);
  crowd.step(2);
  EXPECT_EQ(crowd.fetched_blocks(), 1U);
}

// The new player, the inertialiser, and until it has seen two updates of it the old fade of three.
TEST(Fade, ThatIsInterruptedIsLeftThroughAnInertialiser) {
  Crowd crowd;
  crowd.system->agent(0).play({.clip = 0});
  crowd.system->agent(0).play({.clip = 1, .fade = 30 * frame});
  crowd.step(5);
  crowd.system->agent(0).play({.clip = 2, .fade = 10 * frame});
  EXPECT_EQ(crowd.entities(), 5U);
  crowd.step(2);
  EXPECT_EQ(crowd.entities(), 5U);
  crowd.step();
  EXPECT_EQ(crowd.entities(), 2U);
  crowd.step(30);
  EXPECT_EQ(crowd.entities(), 1U) << "the offset has ended";
}

TEST(Fade, ThatIsInterruptedBeforeItWasShownCostsNothing) {
  Crowd crowd;
  crowd.system->agent(0).play({.clip = 0});
  crowd.step();
  crowd.system->agent(0).play({.clip = 1, .fade = 30 * frame});
  for (int i = 0; i < 5; ++i) crowd.system->agent(0).play({.clip = i % 4, .fade = 30 * frame});
  EXPECT_EQ(crowd.entities(), 5U);
}

TEST(Fade, IsNeverRefused) {
  Crowd crowd;
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(crowd.system->agent(0).play({.clip = i % 4, .fade = ticks_per_second}));
    EXPECT_LE(crowd.entities(), 5U);
    crowd.step(i % 4);
  }
}

TEST(Fade, OverBlendsThatStayIsNeverRefusedButAFifthBlendThatStaysIs) {
  Crowd crowd;
  crowd.system->agent(0).play({.clip = 0});
  for (int i = 1; i < BlendTree::max_players; ++i) {
    EXPECT_TRUE(crowd.system->agent(0).play({.clip = i, .held_fraction = 0.5F}));
  }
  EXPECT_FALSE(crowd.system->agent(0).play({.clip = 1, .held_fraction = 0.5F}));
  EXPECT_TRUE(crowd.system->agent(0).play({.clip = 1, .fade = ticks_per_second}));
  crowd.step(2);
}

TEST(Fade, ThatAStoreOfFixedSizeHasNoRoomForIsACutAndSaysSo) {
  Crowd crowd({.local_store_bytes = 16 * 1024, .tile = 1});
  ASSERT_TRUE(crowd.system->agent(0).play({.clip = 0}));
  while (crowd.system->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}))) {
    ASSERT_LT(crowd.entities(), PoseProgram::max_steps);
  }
  const std::size_t full = crowd.entities();
  crowd.step();
  bool refused = false;
  for (int clip = 1; clip < 4 && !refused; ++clip) {
    refused = !crowd.system->agent(0).play({.clip = clip, .fade = ticks_per_second});
    crowd.step();
  }
  EXPECT_TRUE(refused);
  EXPECT_LE(crowd.entities(), full);
}

TEST(Fade, IsTheSameMotionWhenUpdatesAreSkipped) {
  Crowd every_frame({.schedule = Schedule::levels});
  Crowd skipping({.schedule = Schedule::levels});
  for (Crowd* crowd : {&every_frame, &skipping}) {
    crowd->system->agent(0).play({.clip = 0, .speed = 1.3});
    crowd->system->agent(0).play({.clip = 1, .fade = 20 * frame, .speed = 0.9});
  }
  every_frame.step(12);
  skipping.system->advance(11 * frame);
  skipping.step(1);
  const auto expected = every_frame.system->agent(0).pose();
  const auto actual = skipping.system->agent(0).pose();
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(expected[i], actual[i]) << i;
}

TEST(Fade, ARequestBetweenUpdatesStartsWhenItWasMade) {
  Crowd every_frame({.schedule = Schedule::levels});
  Crowd skipping({.schedule = Schedule::levels});
  for (Crowd* crowd : {&every_frame, &skipping}) {
    crowd->system->agent(0).play({.clip = 0});
    crowd->step(1);
  }
  every_frame.step(3);
  every_frame.system->agent(0).play({.clip = 1, .fade = 20 * frame});
  every_frame.step(4);
  skipping.system->advance(3 * frame);
  skipping.system->agent(0).play({.clip = 1, .fade = 20 * frame});
  skipping.system->advance(3 * frame);
  skipping.step(1);
  const auto expected = every_frame.system->agent(0).pose();
  const auto actual = skipping.system->agent(0).pose();
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(expected[i], actual[i]) << i;
}

}  // namespace
}  // namespace throng::anim::fades_test
