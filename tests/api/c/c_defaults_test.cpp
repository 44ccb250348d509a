// Structs for C begin with the defaults of C++, and may grow.

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/api/c/sized.h"
#include "tests/api/c/c_crowd.h"

namespace throng::c_defaults_test {

/// A struct that got `added` in a later version.
struct Grown {
  std::uint32_t size;
  float first;
  float added;
};

}  // namespace throng::c_defaults_test

template <>
inline constexpr std::array throng::c::known_sizes<throng::c_defaults_test::Grown>{std::size_t{8}, std::size_t{12}};

namespace throng::c_defaults_test {
namespace {

using api_test::CCrowd;
using api_test::why;
using testing::HasSubstr;

TEST(ApiCDefaults, AreThoseOfCpp) {
  EXPECT_EQ(throng_play_default().speed, 1.0F);
  EXPECT_EQ(throng_play_default().loop, 1U);
  EXPECT_EQ(throng_play_default().mask, THRONG_NONE);
  EXPECT_EQ(throng_one_shot_default().speed, static_cast<float>(OneShot{}.speed));
  EXPECT_EQ(throng_layer_default().weight, Layer{}.weight);
  EXPECT_EQ(throng_blend_space_default().is_ground_speed, 1U);
  EXPECT_EQ(throng_blend_space_2d_default().meaning, static_cast<std::uint32_t>(THRONG_PLANE_VELOCITY));
  EXPECT_EQ(throng_crowd_options_default().pus, static_cast<std::uint32_t>(CrowdOptions{}.pus));
  EXPECT_EQ(throng_joint_output_default().skin, THRONG_NONE);
  EXPECT_EQ(throng_look_at_default().yaw, LookAt{}.yaw);
  EXPECT_EQ(throng_reach_default().limb, static_cast<std::uint32_t>(THRONG_RIGHT_ARM));
  EXPECT_EQ(throng_chain_reach_default().iterations, static_cast<std::uint32_t>(ChainReach{}.iterations));
  EXPECT_EQ(throng_foot_placement_default().max_drop, FootPlacement{}.max_drop);
  EXPECT_EQ(throng_noise_default().amplitude, Noise{}.amplitude);
  EXPECT_EQ(throng_spring_chain_default().gravity[1], SpringChain{}.gravity.y);
  EXPECT_EQ(throng_spring_collider_default().radius, SpringCollider{}.radius);
  EXPECT_EQ(throng_ragdoll_default().fade, 0.1F);
  EXPECT_EQ(throng_socket_default().offset.rotation[3], 1.0F);
  EXPECT_EQ(throng_camera_default().pixels_per_unit, Camera{}.pixels_per_unit);
  EXPECT_EQ(throng_lod_rules_default().level_distances[2], LodRules{}.level_distances[2]);
  EXPECT_EQ(throng_load_options_default().size, sizeof(throng_load_options));
}

TEST(ApiCDefaults, AZeroedStructIsRefusedInTheWordsThatHelp) {
  const CCrowd c(1);
  const throng_play zeros{};
  EXPECT_EQ(why(throng_agent_play(c.crowd, c.ids[0], &zeros) != 0),
            "throng_agent_play: the size of a throng_play is wrong; begin with throng_play_default()");
  const throng_layer layer{};
  EXPECT_EQ(throng_agent_add_slot(c.crowd, c.ids[0], &layer), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("throng_layer_default()"));
  const throng_crowd_options options{};
  EXPECT_EQ(throng_crowd_create(c.character, &options), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("throng_crowd_options_default()"));
  throng_camera camera{};
  constexpr float any[16] = {};
  EXPECT_NE(throng_camera_set(&camera, any, any, any, 100), 0);
  EXPECT_EQ(c.heard.size(), 4U);
}

TEST(ApiCDefaults, OfAnUnknownSizeAreZeros) {
  struct {
    throng_play known;
    float more = 7.0F;
  } newer;
  EXPECT_NE(throng_play_fill(&newer.known, sizeof(newer)), 0);
  EXPECT_EQ(newer.known.size, 0U);
  EXPECT_EQ(newer.more, 0.0F);
}

TEST(ApiCDefaults, StandInForMembersThatAProgramDoesNotKnow) {
  EXPECT_TRUE(c::is_known_size<Grown>(8));
  EXPECT_FALSE(c::is_known_size<Grown>(10)) << "no version had it";
  EXPECT_FALSE(c::is_known_size<Grown>(16)) << "it is of a later version";
  const Grown older{.size = 8, .first = 2.0F, .added = 99.0F};  // what lies behind the struct of the older program
  const Grown read = c::completed(&older, Grown{.size = 0, .first = 1.0F, .added = 5.0F});
  EXPECT_EQ(read.first, 2.0F);
  EXPECT_EQ(read.added, 5.0F);
  Grown written = older;
  c::write_known(Grown{.size = 12, .first = 3.0F, .added = 6.0F}, &written);
  EXPECT_EQ(written.size, 8U);
  EXPECT_EQ(written.first, 3.0F);
  EXPECT_EQ(written.added, 99.0F) << "it is not the program's";
}

}  // namespace
}  // namespace throng::c_defaults_test
