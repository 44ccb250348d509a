// Clips blended by two parameters: a velocity aside and ahead.

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/entity/mixer.h"
#include "tests/anim/agent/gait_crowd.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::blend_space_2d_test {
namespace {

std::shared_ptr<const BlendSpace2d> velocities() {
  auto space = BlendSpace2d::create({{.clip = gaits::idle, .place = {0.0F, 0.0F}},
                                     {.clip = gaits::walk, .place = {0.0F, 1.4F}},
                                     {.clip = gaits::jog, .place = {0.0F, 2.6F}},
                                     {.clip = gaits::aside, .place = {1.4F, 0.0F}}},
                                    PlaneMeaning::velocity, 7);
  EXPECT_TRUE(space.has_value()) << space.error().message;
  return *space;
}

struct Walker : GaitCrowd {
  explicit Walker(const glm::vec2& velocity) {
    const Status added = system->agent(0).add_channel(std::make_unique<BlendSpace2dChannel>(velocities(), velocity));
    EXPECT_TRUE(added) << added.error().message;
  }
  void set_velocity(const glm::vec2& velocity) {
    const Status changed = system->agent(0).change<BlendSpace2dChannel>(
        {0}, [&](BlendSpace2dChannel& channel) { channel.set_place(velocity); });
    EXPECT_TRUE(changed) << changed.error().message;
  }
  glm::dvec3 velocity() const {
    const AgentMotion motion = std::as_const(*system).agent(0).motion();
    return motion.displacement(system->clock(), system->clock() + 2 * ticks_per_second).translation / 2.0;
  }
};

TEST(BlendSpace2d, AtAPointPlaysItsClipAlone) {
  Walker walker({1.4F, 0.0F});
  walker.step();
  ASSERT_EQ(walker.players().size(), 1U);
  EXPECT_EQ(walker.players()[0]->clip, static_cast<std::uint32_t>(gaits::aside));
  EXPECT_EQ(walker.players()[0]->speed, 65536);
}

TEST(BlendSpace2d, MixesTheThreeCornersOfATriangle) {
  Walker walker({0.35F, 0.7F});
  walker.step();
  EXPECT_EQ(walker.players().size(), 3U);
  const AgentView agent = std::as_const(*walker.system).agent(0);
  const auto& mixed = agent.pools().private_as<MixerSources>(agent.graph().root());
  EXPECT_NEAR(mixed.weights[0], 0.25F, 1e-6F) << "idle";
  EXPECT_NEAR(mixed.weights[1], 0.5F, 1e-6F) << "walk";
  EXPECT_NEAR(mixed.weights[2], 0.25F, 1e-6F) << "aside";
  EXPECT_EQ(walker.player_of(gaits::idle)->speed, 65536) << "idle plays at its own rate";
}

TEST(BlendSpace2d, LeavesIdleItsOwnRateWhereverItStandsAmongThePoints) {
  const auto space = BlendSpace2d::create({{.clip = gaits::walk, .place = {0.0F, 1.4F}},
                                           {.clip = gaits::jog, .place = {0.0F, 2.6F}},
                                           {.clip = gaits::aside, .place = {1.4F, 0.0F}},
                                           {.clip = gaits::idle, .place = {0.0F, 0.0F}}},
                                          PlaneMeaning::velocity, 7);
  GaitCrowd crowd;
  ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<BlendSpace2dChannel>(*space, glm::vec2(0.0F))));
  crowd.step();
  const auto begin_to_walk = [](BlendSpace2dChannel& channel) { channel.set_place({0.0F, 0.35F}); };
  ASSERT_TRUE(crowd->agent(0).change<BlendSpace2dChannel>({0}, begin_to_walk));
  crowd.step();
  EXPECT_EQ(crowd.player_of(gaits::idle)->speed, 65536);
}

TEST(BlendSpace2d, MovesTheRootAtTheVelocityAskedFor) {
  for (const glm::vec2 wanted :
       {glm::vec2(0.35F, 0.7F), glm::vec2(0.0F, 1.9F), glm::vec2(0.5F, 1.5F), glm::vec2(0.7F)}) {
    Walker walker(wanted);
    walker.step();
    EXPECT_NEAR(walker.velocity().x, static_cast<double>(wanted.x), 0.06) << wanted.x << ", " << wanted.y;
    EXPECT_NEAR(walker.velocity().z, static_cast<double>(wanted.y), 0.06) << wanted.x << ", " << wanted.y;
    EXPECT_NEAR(glm::length(walker.velocity()), static_cast<double>(glm::length(wanted)), 1e-3);
  }
}

TEST(BlendSpace2d, KeepsTheGaitsInStepAllOverThePlane) {
  Walker walker({0.0F, 1.0F});
  std::vector<DataKeyEvent> steps;
  for (int frame = 0; frame < 3000; ++frame) {
    const float turn = 0.003F * static_cast<float>(frame);
    walker.set_velocity({0.6F + 0.5F * std::sin(turn), 1.0F + 0.9F * std::cos(1.7F * turn)});
    for (const DataKeyEvent& event : walker.keys(walker.step())) {
      if (walker.name(event) != "breathe") steps.push_back(event);
    }
  }
  ASSERT_GT(steps.size(), 80U);
  for (std::size_t i = 1; i < steps.size(); ++i) ASSERT_NE(steps[i].name, steps[i - 1].name) << i;
}

TEST(BlendSpace2d, TakesAnyPlaceThatIsFinite) {
  const HeardMisuses heard;
  Walker walker({0.0F, 0.0F});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec2 place :
       {glm::vec2(1e30F, -1e30F), glm::vec2(-5.0F, 0.1F), glm::vec2(nan, 0.0F), glm::vec2(0.0F)}) {
    walker.set_velocity(place);
    walker.step();
    EXPECT_GE(walker.players().size(), 1U);
  }
  walker.set_velocity({nan, 1.0F});
  EXPECT_EQ(std::as_const(*walker.system).agent(0).channel<BlendSpace2dChannel>({0})->place(), glm::vec2(0.0F));
  EXPECT_EQ(HeardMisuses::all().size(), 2U) << "both that are not";
}

TEST(BlendSpace2d, RefusesAClipThatTheCharacterDoesNotHave) {
  const auto refused = BlendSpace2d::create({{.clip = 9, .place = {0.0F, 0.0F}}}, PlaneMeaning::plain, 7);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().message,
            "point 0 of a blend space plays clip 9, and the character has 7: give it one of these");
}

}  // namespace
}  // namespace throng::anim::blend_space_2d_test
