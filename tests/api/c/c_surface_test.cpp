// Materials, morphs and bounds through the functions for C.

#include <bit>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"
#include "tests/api/smiling.h"
#include "tests/own_folder.h"

namespace throng::c_surface_test {
namespace {

using api_test::ApiCrowd;
using api_test::CCrowd;
using api_test::mannequin;
using api_test::smiling;
using testing::ElementsAre;
using testing::HasSubstr;

/// The smiling character in C, which comes through a pack.
class CSmiling {
 public:
  CSmiling() {
    const test::OwnFolder folder;
    const std::string pack = folder.path() / "smiling.pack";
    const Character own = smiling();
    EXPECT_TRUE(save(pack, {&own, 1}));
    throng_load_options options = throng_load_options_default();
    options.keep_meshes = 1;
    throng_file* const file = throng_load_with(pack.c_str(), &options);
    EXPECT_NE(file, nullptr) << throng_last_error();
    character = throng_file_character(file, 0);
    throng_file_free(file);
  }
  ~CSmiling() { throng_character_free(character); }
  CSmiling(const CSmiling&) = delete;
  CSmiling& operator=(const CSmiling&) = delete;

  throng_mesh mesh() const {
    throng_mesh mesh = throng_mesh_default();
    EXPECT_EQ(throng_character_mesh(character, 0, &mesh), 0) << throng_last_error();
    return mesh;
  }

  throng_character* character = nullptr;
};

TEST(ApiCMesh, ShowsItsMaterialAsTheFileHasIt) {
  const CSmiling smile;
  const throng_mesh mesh = smile.mesh();
  EXPECT_EQ(mesh.tangents[7], -1.0F);
  EXPECT_EQ(mesh.colors[5], 0.5F);
  EXPECT_EQ(mesh.texture_coords[2], 0.6F);
  EXPECT_EQ(mesh.base_color_texels[3], 4);
  EXPECT_EQ(mesh.normal_texture.coords[2], 0.1F);
  EXPECT_EQ(mesh.normal_texture.texels[3], 8);
  EXPECT_EQ(mesh.normal_texture.width, 1);
  EXPECT_EQ(mesh.normal_texture.height, 1);
  for (const throng_texture& none : {mesh.metallic_roughness_texture, mesh.occlusion_texture, mesh.emission_texture}) {
    EXPECT_EQ(none.texels, nullptr);
    EXPECT_EQ(none.coords, nullptr);
  }
  EXPECT_EQ(mesh.normal_scale, 0.5F);
  EXPECT_EQ(mesh.metallic, 0.25F);
  EXPECT_EQ(mesh.roughness, 0.75F);
  EXPECT_EQ(mesh.occlusion_strength, 1.0F);
  EXPECT_THAT(mesh.emission, ElementsAre(0.0F, 1.0F, 2.0F));
  EXPECT_EQ(mesh.alpha, static_cast<std::uint32_t>(THRONG_ALPHA_MASK));
  EXPECT_EQ(mesh.alpha_cutoff, 0.4F);
  EXPECT_EQ(mesh.double_sided, 1U);
  EXPECT_EQ(mesh.unlit, 0U);
}

TEST(ApiCMesh, BeginsWithTheFactorsOfCpp) {
  const throng_mesh mesh = throng_mesh_default();
  EXPECT_THAT(mesh.base_color, ElementsAre(1.0F, 1.0F, 1.0F, 1.0F));
  EXPECT_EQ(mesh.metallic, MeshView{}.metallic);
  EXPECT_EQ(mesh.roughness, MeshView{}.roughness);
  EXPECT_EQ(mesh.name, nullptr);
}

TEST(ApiCMorphs, AreToldWithWhatTheyDoToTheSurface) {
  const api_test::CMisuses misuses;
  const CSmiling smile;
  EXPECT_STREQ(throng_character_morph_name(smile.character, 0), "smile");
  EXPECT_EQ(throng_character_morph_name(smile.character, 1), nullptr);
  const throng_mesh mesh = smile.mesh();
  ASSERT_EQ(mesh.morph_delta_count, 1U);
  EXPECT_EQ(mesh.morph_deltas[0].vertex, 2U);
  EXPECT_EQ(mesh.morph_deltas[0].position[1], 0.5F);
  EXPECT_EQ(mesh.morph_deltas[0].normal[1], 1.0F);

  throng_crowd* const crowd = throng_crowd_create(smile.character, nullptr);
  throng_id agent;
  throng_crowd_add_agents(crowd, api_test::first_character, 1, &agent);
  float weight = 7.0F;
  EXPECT_EQ(throng_agent_morph_weights(crowd, agent, &weight, 1), 0) << "it plays nothing";
  EXPECT_EQ(weight, 0.0F);
  throng_play play = throng_play_default();
  play.clip = 0;
  EXPECT_EQ(throng_agent_play(crowd, agent, &play), 0) << throng_last_error();
  throng_crowd_advance(crowd, 0.25);
  EXPECT_EQ(throng_agent_morph_weights(crowd, agent, &weight, 1), 1);
  EXPECT_NEAR(weight, 0.25F, 1e-3F);
  EXPECT_EQ(throng_agent_morph_weights(crowd, agent, &weight, 0), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("no room for the weight of each morph"));
  throng_crowd_free(crowd);
}

TEST(ApiCBounds, AreThoseOfCpp) {
  const CCrowd c(1);
  ApiCrowd cpp(1);
  const std::uint32_t walk = c.clip("walk");
  throng_bounding_sphere sphere;
  throng_bounding_box box;
  EXPECT_EQ(throng_character_bounds(c.character, &sphere), 0);
  EXPECT_EQ(std::bit_cast<BoundingSphere>(sphere), mannequin().bounds());
  EXPECT_EQ(throng_character_clip_bounds(c.character, walk, &box), 0);
  EXPECT_EQ(std::bit_cast<BoundingBox>(box), mannequin().bounds(ClipId{walk}));
  c.play(0, walk);
  cpp.agent(0).play({.clip = {walk}});
  c.step(10);
  cpp.step(10);
  EXPECT_EQ(throng_crowd_bounds(c.crowd, c.ids[0], &box), 0);
  EXPECT_EQ(std::bit_cast<BoundingBox>(box), cpp->bounds({0}));
}

TEST(ApiCBounds, OfAnAbsentClipOrAgentAreRefused) {
  const CCrowd c(1);
  throng_bounding_box box;
  EXPECT_NE(throng_character_clip_bounds(c.character, 99, &box), 0);
  EXPECT_STREQ(throng_last_error(), "throng_character_clip_bounds: the character has no clip of this number");
  EXPECT_NE(throng_crowd_bounds(c.crowd, {7, 7}, &box), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("throng_crowd_bounds: an agent of this id"));
  EXPECT_NE(throng_character_bounds(c.character, nullptr), 0);
  EXPECT_EQ(c.heard.size(), 2U) << "an absent clip is asked for, not played";
}

}  // namespace
}  // namespace throng::c_surface_test
