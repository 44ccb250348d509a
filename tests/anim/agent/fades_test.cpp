#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {
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
      const AgentUpdate update{.agent = 0};
      system->update({&update, 1});
    }
  }
  std::uint64_t fetched_blocks() const { return system->report().copies.bytes_in / entity_header_bytes; }
  std::unique_ptr<AnimationSystem> system;
};

TEST(Fade, TakesTwoPlayersAndABlenderWhileItRunsAndOnePlayerAfterwards) {
  Crowd crowd;
  crowd.system->play(0, {.clip = 0});
  crowd.step();
  EXPECT_EQ(crowd.fetched_blocks(), 1U);
  crowd.system->play(0, {.clip = 1, .fade = 10 * frame});
  crowd.step(9);
  EXPECT_EQ(crowd.fetched_blocks(), 3U);
  crowd.step(2);
  EXPECT_EQ(crowd.fetched_blocks(), 1U);
}

TEST(Fade, AnInterruptedFadeFadesOnFromWhereItStands) {
  Crowd crowd;
  crowd.system->play(0, {.clip = 0});
  crowd.system->play(0, {.clip = 1, .fade = 30 * frame});
  crowd.step(5);
  crowd.system->play(0, {.clip = 2, .fade = 10 * frame});
  crowd.step(1);
  EXPECT_EQ(crowd.fetched_blocks(), 5U);
  crowd.step(10);
  EXPECT_EQ(crowd.fetched_blocks(), 1U) << "the outer fade is over, so nothing below it counts";
}

TEST(Fade, AnInnerFadeThatEndsFirstIsReplacedByItsTarget) {
  Crowd crowd;
  crowd.system->play(0, {.clip = 0});
  crowd.system->play(0, {.clip = 1, .fade = 5 * frame});
  crowd.system->play(0, {.clip = 2, .fade = 30 * frame});
  crowd.step(3);
  EXPECT_EQ(crowd.fetched_blocks(), 5U);
  crowd.step(4);
  EXPECT_EQ(crowd.fetched_blocks(), 3U);
}

TEST(Fade, ATreeThatIsFullRefusesInsteadOfSnapping) {
  Crowd crowd;
  crowd.system->play(0, {.clip = 0});
  for (int i = 0; i < BlendTree::max_players - 1; ++i) {
    EXPECT_TRUE(crowd.system->play(0, {.clip = i % 4, .fade = ticks_per_second}));
  }
  EXPECT_FALSE(crowd.system->play(0, {.clip = 1, .fade = ticks_per_second}));
  crowd.step();
}

TEST(Fade, IsTheSameMotionWhenUpdatesAreSkipped) {
  Crowd every_frame({.schedule = Schedule::levels});
  Crowd skipping({.schedule = Schedule::levels});
  for (Crowd* crowd : {&every_frame, &skipping}) {
    crowd->system->play(0, {.clip = 0, .speed = 1.3});
    crowd->system->play(0, {.clip = 1, .fade = 20 * frame, .speed = 0.9});
  }
  every_frame.step(12);
  skipping.system->advance(11 * frame);
  skipping.step(1);
  const auto expected = every_frame.system->pose(0);
  const auto actual = skipping.system->pose(0);
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(expected[i], actual[i]) << i;
}

TEST(Fade, ARequestBetweenUpdatesStartsWhenItWasMade) {
  Crowd every_frame({.schedule = Schedule::levels});
  Crowd skipping({.schedule = Schedule::levels});
  for (Crowd* crowd : {&every_frame, &skipping}) {
    crowd->system->play(0, {.clip = 0});
    crowd->step(1);
  }
  every_frame.step(3);
  every_frame.system->play(0, {.clip = 1, .fade = 20 * frame});
  every_frame.step(4);
  skipping.system->advance(3 * frame);
  skipping.system->play(0, {.clip = 1, .fade = 20 * frame});
  skipping.system->advance(3 * frame);
  skipping.step(1);
  const auto expected = every_frame.system->pose(0);
  const auto actual = skipping.system->pose(0);
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(expected[i], actual[i]) << i;
}

}  // namespace
}  // namespace throng::anim
