// Building characters of a host's own data through the functions for C.

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_builder_test {
namespace {

using api_test::CCrowd;
using api_test::why;
using testing::HasSubstr;

const float half = std::sqrt(0.5F);
const float seconds[] = {0.0F, 1.0F};
const float places[] = {0.0F, 0.0F, 0.0F, 2.0F, 0.0F, 0.0F};
const float turns[] = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, half, half};
const float sizes[] = {0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F, 0.0F, 0.0F, 0.0F,   // in-tangent, value, out-tangent
                       0.0F, 0.0F, 0.0F, 1.0F, 3.0F, 1.0F, 0.0F, 0.0F, 0.0F};  // of the second key
const float glow[] = {0.0F, 8.0F};
const float bound_higher[] = {1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F,  0.0F, 0.0F,
                              0.0F, 0.0F, 1.0F, 0.0F, 0.0F, -2.0F, 0.0F, 1.0F};

throng_bone_keys keys(const float* values, std::uint32_t form = THRONG_FORM_LINEAR) {
  return {.seconds = seconds, .values = values, .count = 2, .form = form};
}

/// A builder of C that ends with its test: a root, and a head 1 m above it that was bound 2 m above it, with a clip.
class CBuilder {
 public:
  CBuilder() : own(throng_builder_create("small")) {
    throng_bone_to_build bone = throng_bone_to_build_default();
    bone.name = "root";
    EXPECT_EQ(throng_builder_add_bone(own, &bone), 0U);
    bone.name = "tip";
    bone.parent = 0;
    bone.role = "head";
    bone.rest.translation[1] = 1.0F;
    bone.inverse_bind = bound_higher;
    EXPECT_EQ(throng_builder_add_bone(own, &bone), 1U);
    EXPECT_EQ(throng_builder_add_clip(own, "clip", 1.0), 0U);
  }
  ~CBuilder() { throng_builder_free(own); }
  CBuilder(const CBuilder&) = delete;
  CBuilder& operator=(const CBuilder&) = delete;

  throng_character* build(const throng_load_options* options = nullptr) const {
    throng_file* const file = throng_builder_build(own, options);
    if (file == nullptr) return nullptr;
    throng_character* const character = throng_file_character(file, 0);
    throng_file_free(file);
    return character;
  }

  throng_builder* own;
};

void set_up(throng_builder* builder) {
  const throng_bone_keys moved = keys(places), turned = keys(turns), scaled = keys(sizes, THRONG_FORM_CUBIC_SPLINE);
  EXPECT_EQ(throng_builder_set_translations(builder, 0, 0, &moved), 0);
  EXPECT_EQ(throng_builder_set_rotations(builder, 0, 0, &turned), 0);
  EXPECT_EQ(throng_builder_set_scales(builder, 0, 1, &scaled), 0);
  EXPECT_EQ(throng_builder_add_data_key(builder, 0, "step", 0.25), 0);
  EXPECT_EQ(throng_builder_add_curve(builder, 0, "glow", seconds, glow, 2), 0);
}

/// Builds the character of CBuilder and set_up() in C++.
Character built_in_cpp() {
  CharacterBuilder builder("small");
  builder.add_bone({.name = "root"});
  builder.add_bone({.name = "tip",
                    .parent = 0,
                    .rest = {.translation = {0.0F, 1.0F, 0.0F}},
                    .inverse_bind = to_mat4(bound_higher),
                    .role = "head"});
  builder.add_clip("clip", 1.0);
  const Vec3 to[] = {{}, {2.0F, 0.0F, 0.0F}};
  const Quat by[] = {{}, {.z = half, .w = half}};
  const Vec3 one{1.0F, 1.0F, 1.0F}, high{1.0F, 3.0F, 1.0F};
  const Vec3 spline[] = {{}, one, {}, {}, high, {}};
  builder.set_translations(0, 0, {.seconds = seconds, .values = to});
  builder.set_rotations(0, 0, {.seconds = seconds, .values = by});
  builder.set_scales(0, 1, {.seconds = seconds, .values = spline, .form = KeyForm::cubic_spline});
  return builder.build()->characters.front();
}

/// Returns the hash of an agent that has played a clip of `character` for a third of a second.
std::uint64_t hash_in_c(const throng_character* character) {
  throng_crowd_options options = throng_crowd_options_default();
  options.hash = 1;
  throng_crowd* const crowd = throng_crowd_create(character, &options);
  throng_pose_request request{};
  throng_crowd_add_agents(crowd, api_test::first_character, 1, &request.agent);
  throng_play play = throng_play_default();
  play.clip = 0;
  EXPECT_EQ(throng_agent_play(crowd, request.agent, &play), 0) << throng_last_error();
  throng_crowd_advance(crowd, 1.0 / 3.0);
  EXPECT_EQ(throng_crowd_update(crowd, &request, 1), 0) << throng_last_error();
  const std::uint64_t hash = throng_crowd_pose_hash(crowd);
  EXPECT_NEAR(throng_agent_curve(crowd, request.agent, 0), 8.0F / 3.0F, 1e-2F);
  throng_key key;
  EXPECT_EQ(throng_agent_keys(crowd, request.agent, 0.0, 1.0 / 3.0, THRONG_KEYS_ALL, &key, 1), 1U);
  throng_crowd_free(crowd);
  return hash;
}

std::uint64_t hash_in_cpp(const Character& character) {
  Crowd crowd = std::move(*Crowd::create(character, {.hash = true}));
  const PoseRequest request{.agent = crowd.add_agent()};
  crowd.agent(request.agent).play({.clip = {0}});
  crowd.advance(to_ticks(1.0 / 3.0));
  crowd.update({&request, 1});
  return crowd.debug().pose_hash();
}

TEST(ApiCBuilder, BuildsTheCharacterThatTheOneForCppBuilds) {
  const CBuilder builder;
  set_up(builder.own);
  throng_character* const character = builder.build();
  ASSERT_NE(character, nullptr) << throng_last_error();
  EXPECT_STREQ(throng_character_clip_name(character, 0), "clip");
  EXPECT_STREQ(throng_character_key_name(character, 0), "step");
  EXPECT_STREQ(throng_character_curve_name(character, 0), "glow");
  const std::uint32_t tip = throng_character_find_bone(character, "tip");
  EXPECT_STREQ(throng_character_bone_name(character, throng_character_bone_parent(character, tip)), "root");
  EXPECT_EQ(hash_in_c(character), hash_in_cpp(built_in_cpp()));
  throng_character_free(character);
}

TEST(ApiCBuilder, TakesTheOptionsOfLoading) {
  const api_test::CMisuses misuses;
  const CBuilder builder;
  throng_load_options options = throng_load_options_default();
  options.metres_a_unit = 0.01;
  throng_character* const character = builder.build(&options);
  ASSERT_NE(character, nullptr) << throng_last_error();
  EXPECT_NEAR(throng_character_height(character), 0.01, 1e-6);
  throng_character_free(character);
  options.size = 1;
  EXPECT_EQ(builder.build(&options), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("throng_load_options_default()"));
}

/// A triangle beside the tip, which moves it, with an image of one red texel.
struct Triangle {
  float positions[9] = {1.0F, 1.0F, 0.0F, 2.0F, 1.0F, 0.0F, 1.0F, 2.0F, 0.0F};
  float normals[9] = {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F};
  float coords[6] = {0.0F, 0.0F, 1.0F, 0.0F, 0.5F, 1.0F};
  std::uint16_t bones[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  float weights[12] = {1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F};
  std::uint32_t indices[3] = {0, 1, 2};
  std::uint8_t texels[4] = {255, 0, 0, 255};

  throng_mesh mesh() const {
    throng_mesh mesh = throng_mesh_default();
    mesh.name = "flag";
    mesh.vertex_count = 3;
    mesh.index_count = 3;
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.texture_coords = coords;
    mesh.palette_entries = bones;
    mesh.weights = weights;
    mesh.indices = indices;
    mesh.base_color_texels = texels;
    mesh.texture_width = mesh.texture_height = 1;
    mesh.base_color[1] = 0.5F;
    return mesh;
  }
};

TEST(ApiCBuilder, KeepsTheMeshThatItWasTold) {
  const CBuilder builder;
  const Triangle triangle;
  const throng_mesh told = triangle.mesh();
  EXPECT_EQ(throng_builder_add_mesh(builder.own, &told), 0) << throng_last_error();
  throng_load_options options = throng_load_options_default();
  options.keep_meshes = 1;
  throng_character* const character = builder.build(&options);
  ASSERT_NE(character, nullptr) << throng_last_error();
  throng_mesh mesh = throng_mesh_default();
  ASSERT_EQ(throng_character_mesh(character, 0, &mesh), 0);
  EXPECT_STREQ(mesh.name, "flag");
  EXPECT_EQ(mesh.vertex_count, 3U);
  EXPECT_EQ(mesh.indices[2], 2U);
  EXPECT_EQ(mesh.positions[3] - mesh.positions[0], 1.0F) << "the palette's space may lie elsewhere";
  EXPECT_EQ(mesh.texture_coords[4], 0.5F);
  EXPECT_EQ(mesh.base_color[1], 0.5F);
  EXPECT_EQ(mesh.base_color_texels[0], 255);
  EXPECT_EQ(mesh.texture_width, 1);
  throng_character_free(character);
}

TEST(ApiCBuilder, RefusesNullPointersWrongSizesAndUnknownConstants) {
  const CCrowd hears(1);
  const CBuilder builder;
  const Triangle triangle;
  throng_mesh mesh = triangle.mesh();
  mesh.weights = nullptr;
  EXPECT_EQ(why(throng_builder_add_mesh(builder.own, &mesh) != 0), "throng_builder_add_mesh: a pointer is null");
  mesh = triangle.mesh();
  mesh.alpha = 3;
  EXPECT_THAT(why(throng_builder_add_mesh(builder.own, &mesh) != 0), HasSubstr("throng_mesh::alpha is none"));
  mesh.size = 8;
  EXPECT_THAT(why(throng_builder_add_mesh(builder.own, &mesh) != 0), HasSubstr("begin with throng_mesh_default()"));
  const throng_bone_to_build zeros{};
  EXPECT_EQ(throng_builder_add_bone(builder.own, &zeros), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("begin with throng_bone_to_build_default()"));
  const throng_bone_keys wrong = keys(places, 9), none = keys(nullptr);
  EXPECT_THAT(why(throng_builder_set_scales(builder.own, 0, 0, &wrong) != 0), HasSubstr("::form is none of its"));
  EXPECT_THAT(why(throng_builder_set_scales(builder.own, 0, 0, &none) != 0), HasSubstr("a pointer is null"));
  EXPECT_NE(throng_builder_add_curve(builder.own, 0, "glow", seconds, nullptr, 2), 0);
  EXPECT_NE(throng_builder_add_data_key(builder.own, 0, nullptr, 0.0), 0);
  EXPECT_EQ(throng_builder_add_clip(nullptr, "clip", 1.0), THRONG_NONE);
  EXPECT_EQ(throng_builder_create(nullptr), nullptr);
  EXPECT_EQ(throng_builder_build(nullptr, nullptr), nullptr);
  EXPECT_EQ(hears.heard.size(), 11U);
  throng_character* const character = builder.build();
  EXPECT_NE(character, nullptr) << "a refused call leaves no fault";
  throng_character_free(character);
  throng_builder_free(nullptr);
}

TEST(ApiCBuilder, NamesTheFirstFaultWhenItBuilds) {
  const CBuilder builder;
  const throng_bone_keys turned = keys(turns);
  EXPECT_EQ(throng_builder_set_rotations(builder.own, 0, 9, &turned), 0);
  EXPECT_EQ(throng_builder_add_data_key(builder.own, THRONG_NONE, "key", 0.0), 0);
  EXPECT_EQ(builder.build(), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("clip \"clip\": there is no bone 9"));
  const CBuilder orphans;
  throng_bone_to_build bone = throng_bone_to_build_default();
  bone.name = "orphan";
  bone.parent = 7;
  EXPECT_EQ(throng_builder_add_bone(orphans.own, &bone), 2U);
  EXPECT_EQ(orphans.build(), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("bone \"orphan\": its parent is not a bone before it"));
  const CBuilder roles;
  bone.parent = 0;
  bone.role = "paw";
  EXPECT_EQ(throng_builder_add_bone(roles.own, &bone), 2U);
  EXPECT_EQ(roles.build(), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("no part of the body named \"paw\""));
}

}  // namespace
}  // namespace throng::c_builder_test
