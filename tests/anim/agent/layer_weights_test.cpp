// The weight of a layer moves by itself, evenly and by the clock.

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/simple_channel.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::layer_weights_test {
namespace {

constexpr int fade_frames = 20;
constexpr Ticks fade = fade_frames * frame_ticks;

/// A walk, and a wave over it that is not seen yet.
CrowdRig layered() {
  CrowdRig crowd;
  crowd->agent(0).play({.clip = 0});
  EXPECT_TRUE(crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}), {.weight = 0.0F}));
  return crowd;
}

const EaseBlender& blender(const CrowdRig& crowd) {
  const AgentView agent = crowd->agent(0);
  return agent.pools().as<EaseBlender>(agent.graph().root());
}

TEST(LayerWeight, MovesEvenlyToWhatWasSet) {
  CrowdRig crowd = layered();
  ASSERT_TRUE(crowd->agent(0).set_channel_weight({1}, 0.8F, fade));
  for (int frame = 1; frame <= fade_frames + 5; ++frame) {
    crowd.step();
    const float share = std::min(static_cast<float>(frame) / fade_frames, 1.0F);
    EXPECT_NEAR(blender(crowd).fraction, 0.8F * share, 1e-5F) << frame;
  }
  EXPECT_EQ(blender(crowd).fraction, 0.8F);
}

TEST(LayerWeight, DoesNotDependOnWhichFramesArePosed) {
  CrowdRig each_frame = layered();
  CrowdRig skipped = layered();
  for (CrowdRig* crowd : {&each_frame, &skipped}) {
    crowd->step(3);
    crowd->system->agent(0).set_channel_weight({1}, 1.0F, fade);
  }
  for (const int frames : {1, 7, 4, 11, 20}) {
    each_frame.step(frames);
    for (int frame = 1; frame < frames; ++frame) skipped->advance(frame_ticks);
    skipped.step();
    EXPECT_TRUE(each_frame.bones_unlike(skipped).empty());
  }
}

TEST(LayerWeight, IsTheSameForWhoIsPosedAheadOfTheClock) {
  CrowdRig now = layered();
  CrowdRig ahead = layered();
  for (int frame = 0; frame <= fade_frames + 8; frame += 4) {
    const PoseRequest early{.agent = {0}, .look_ahead = 4 * frame_ticks, .palette = memory_of(ahead.palette())};
    ahead->update({&early, 1});
    now.step(2);
    ahead->advance(2 * frame_ticks);
    for (CrowdRig* crowd : {&now, &ahead}) {
      if (frame == 0) crowd->system->agent(0).set_channel_weight({1}, 1.0F, fade);
    }
    now.step(2);
    ahead->advance(2 * frame_ticks);
    if (frame == 0) continue;  // it was posed before it was asked
    EXPECT_TRUE(now.bones_unlike(ahead).empty()) << frame;
  }
}

TEST(LayerWeight, TurnsRoundWhereItIs) {
  CrowdRig crowd = layered();
  crowd->agent(0).set_channel_weight({1}, 1.0F, fade);
  crowd.step(fade_frames / 2);
  crowd->agent(0).set_channel_weight({1}, 0.0F, fade);
  crowd.step(fade_frames / 2);
  EXPECT_NEAR(blender(crowd).fraction, 0.25F, 1e-5F);
  crowd.step(fade_frames);
  EXPECT_EQ(blender(crowd).fraction, 0.0F);
}

TEST(LayerWeight, GoesOnAfterASnapshot) {
  CrowdRig crowd = layered();
  crowd->agent(0).set_channel_weight({1}, 1.0F, fade);
  crowd.step(5);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  CrowdRig other = layered();
  other->agent(0).set_channel_weight({1}, 1.0F, fade);
  other.step(15);
  crowd->agent(0).set_channel_weight({1}, 0.1F);
  crowd.step(3);
  ASSERT_TRUE(crowd->restore(snapshot));
  crowd.step(10);
  EXPECT_TRUE(crowd.bones_unlike(other).empty());
  crowd.step(20);
  EXPECT_EQ(blender(crowd).fraction, 1.0F);
}

TEST(LayerWeight, IsHeldOnceItHasArrived) {
  CrowdRig crowd = layered();
  crowd->agent(0).set_channel_weight({1}, 1.0F, fade);
  crowd.step(fade_frames - 1);
  EXPECT_EQ(blender(crowd).flags, EaseBlender::linear);
  crowd.step();
  EXPECT_EQ(blender(crowd).flags, EaseBlender::held);
}

TEST(LayerWeight, MovesOnWhileTheLayerPlaysNothing) {
  CrowdRig crowd = layered();
  const auto empty = crowd->agent(0).add_channel(std::make_unique<CrossFadeChannel>(), {.weight = 0.0F});
  ASSERT_TRUE(empty);
  crowd->agent(0).set_channel_weight(*empty, 1.0F, fade);
  crowd.step(fade_frames / 2);
  crowd->agent(0).play(*empty, {.clip = 2});
  crowd.step();
  EXPECT_NEAR(blender(crowd).fraction, 11.0F / 20.0F, 1e-5F);
}

TEST(LayerWeight, RefusesAFadeThatIsNone) {
  const HeardMisuses heard;
  CrowdRig crowd = layered();
  EXPECT_FALSE(crowd->agent(0).set_channel_weight({1}, 1.0F, -fade));
  EXPECT_EQ(heard.all().size(), 1U);
}

}  // namespace
}  // namespace throng::anim::layer_weights_test
