// What agents play through the functions for C.

#include <vector>

#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_channels_test {
namespace {

using api_test::ApiCrowd;
using api_test::CCrowd;
using api_test::first_character;
using api_test::mannequin;

TEST(ApiCChannels, AMaskedLayerCoversTheArmAlone) {
  const CCrowd c(1);
  ApiCrowd cpp(1);
  c.play(0, c.clip("walk"));
  cpp.agent(0).play({.clip = mannequin().find_clip("walk")});
  const throng_bone_weight arm{.bone = c.bone("shoulder.R"), .weight = 1.0F};
  throng_layer layer = throng_layer_default();
  layer.mask = throng_crowd_add_mask(c.crowd, first_character, &arm, 1, 0.0F);
  layer.weight = 0.0F;
  const std::uint32_t channel = throng_agent_add_clips(c.crowd, c.ids[0], &layer);
  ASSERT_NE(channel, THRONG_NONE) << throng_last_error();
  throng_play wave = throng_play_default();
  wave.clip = c.clip("wave");
  EXPECT_EQ(throng_agent_play_on(c.crowd, c.ids[0], channel, &wave), 0);
  EXPECT_EQ(throng_agent_set_weight(c.crowd, c.ids[0], channel, 0.8F, 0.25F), 0);

  const BoneWeight same_arm{.bone = *mannequin().find_bone("shoulder.R")};
  const MaskId mask = cpp->add_mask(0, {&same_arm, 1});
  const auto above = cpp.agent(0).add_clips({.weight = 0.0F, .mask = mask});
  ASSERT_TRUE(above);
  cpp.agent(0).play(*above, {.clip = mannequin().find_clip("wave")});
  cpp.agent(0).set_weight(*above, 0.8F, ticks_per_second / 4);
  c.step(30);
  cpp.step(30);
  EXPECT_EQ(c.hash(), cpp.hash());
  EXPECT_EQ(throng_agent_remove_channel(c.crowd, c.ids[0], channel), 0);
  EXPECT_NE(throng_agent_remove_channel(c.crowd, c.ids[0], channel), 0) << "it is gone";
}

TEST(ApiCChannels, APlaneBlendsItsClipsAsThatOfCppDoes) {
  const CCrowd c(1);
  ApiCrowd cpp(1);
  const char* const names[] = {"idle", "walk", "step left", "walk back"};
  const float places[][2] = {{0.0F, 0.0F}, {0.0F, 1.35F}, {0.6F, 0.0F}, {0.0F, -0.8F}};
  std::vector<throng_blend_point_2d> points;
  std::vector<BlendPoint2d> own_points;
  for (int i = 0; i < 4; ++i) {
    points.push_back({.clip = c.clip(names[i]), .x = places[i][0], .y = places[i][1], .pace = THRONG_PACE_AUTOMATIC});
    own_points.push_back({.clip = mannequin().find_clip(names[i]), .x = places[i][0], .y = places[i][1]});
  }
  throng_blend_space_2d space = throng_blend_space_2d_default();
  space.points = points.data();
  space.point_count = 4;
  const std::uint32_t channel = throng_agent_add_blend_space_2d(c.crowd, c.ids[0], &space, nullptr);
  const auto own = cpp.agent(0).add(BlendSpace2d{.points = own_points});
  ASSERT_TRUE(own);
  EXPECT_EQ(throng_agent_set_parameters(c.crowd, c.ids[0], channel, 0.2F, 0.6F), 0);
  cpp.agent(0).set_parameters(*own, 0.2F, 0.6F);
  c.step(30);
  cpp.step(30);
  EXPECT_EQ(c.hash(), cpp.hash());
  points[2].pace = 7;
  EXPECT_EQ(throng_agent_add_blend_space_2d(c.crowd, c.ids[0], &space, nullptr), THRONG_NONE);
  EXPECT_STREQ(throng_last_error(), "throng_agent_add_blend_space_2d: the pace of a point is none of its constants");
}

TEST(ApiCChannels, TellTheEndOfAClipAndTheRootOfACutScene) {
  const CCrowd c(1);
  const throng_place mark{.position = {1.0F, 0.0F, 2.0F}, .rotation = {0.0F, 0.0F, 0.0F, 1.0F}};
  throng_play wave = throng_play_default();
  wave.clip = c.clip("wave");
  wave.loop = 0;
  throng_place root;
  throng_agent_play(c.crowd, c.ids[0], &wave);
  EXPECT_EQ(throng_agent_absolute_root(c.crowd, c.ids[0], &root), 0);
  wave.absolute_root = &mark;
  throng_agent_play(c.crowd, c.ids[0], &wave);
  c.step();
  ASSERT_EQ(throng_agent_absolute_root(c.crowd, c.ids[0], &root), 1);
  EXPECT_NEAR(root.position[2], 2.0F, 0.01F);
  const double seconds = throng_character_clip_seconds(c.character, wave.clip);
  throng_crowd_advance(c.crowd, seconds);
  throng_clip_end ends[4];
  ASSERT_EQ(throng_agent_ends(c.crowd, c.ids[0], 0.5 * seconds, seconds + 0.01, ends, 4), 1U);
  EXPECT_EQ(ends[0].clip, wave.clip);
  EXPECT_NEAR(ends[0].time, seconds, 1e-6);
}

TEST(ApiCChannels, ACurveOfNoNameIsAMisuse) {
  const CCrowd c(1);
  EXPECT_EQ(throng_character_curve_name(c.character, 0), nullptr);
  EXPECT_EQ(throng_agent_curve(c.crowd, c.ids[0], 0), 0.0F);
  EXPECT_EQ(c.heard.size(), 1U);
}

}  // namespace
}  // namespace throng::c_channels_test
