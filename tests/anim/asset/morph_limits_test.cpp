#include "engine/anim/asset/morph_limits.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"

namespace throng::anim::morph_limits_test {
namespace {

using ::testing::HasSubstr;

/// A model with `count` morphs. Morph i moves vertex i % 2 by i decimetres, and its clip gives each a weight of 2.
Model model_with_morphs(int count) {
  Model model = synthetic_model(8, 1);
  SkinnedMesh mesh;
  for (int vertex = 0; vertex < 2; ++vertex) {
    mesh.positions.emplace_back(0.0F, 1.0F, static_cast<float>(vertex));
    mesh.normals.emplace_back(0.0F, 0.0F, 1.0F);
    mesh.palette_entries.emplace_back(0, 0, 0, 0);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
  }
  MorphTrack track{.interpolation = Interpolation::linear, .morphs = {}, .times = {0.0F, 1.0F}, .weights = {}};
  for (int i = 0; i < count; ++i) {
    model.morphs.push_back({.name = "morph " + std::to_string(i)});
    const float metres = 0.1F * static_cast<float>(i);
    mesh.morph_deltas.push_back({.vertex = static_cast<std::uint32_t>(i % 2),
                                 .morph = static_cast<std::uint32_t>(i),
                                 .position = {0.0F, metres, 0.0F},
                                 .normal = {}});
    track.morphs.push_back(i);
  }
  track.weights.assign(static_cast<std::size_t>(count), 0.0F);
  track.weights.resize(static_cast<std::size_t>(2 * count), -2.0F);
  model.meshes = {mesh};
  model.clips.front().morph_tracks = {track};
  return model;
}

TEST(MorphLimits, KeepTheStrongestAndNameTheOthers) {
  Model model = model_with_morphs(5);
  const std::string sentence = limit_morphs(model, 2);
  EXPECT_THAT(sentence, HasSubstr("clips animate 4 morph targets, of which the strongest 2 are kept"));
  EXPECT_THAT(sentence, HasSubstr("left out: morph 1; morph 2")) << "nobody misses morph 0, which moves nothing";
  ASSERT_EQ(model.morphs.size(), 2U);
  EXPECT_EQ(model.morphs[0].name, "morph 3");
  const std::vector<MorphDelta>& deltas = model.meshes.front().morph_deltas;
  ASSERT_EQ(deltas.size(), 2U);
  EXPECT_EQ(deltas[0].vertex, 0U) << "they are sorted by vertex";
  EXPECT_EQ(deltas[0].morph, 1U);
  EXPECT_EQ(deltas[1].morph, 0U);
  const MorphTrack& track = model.clips.front().morph_tracks.front();
  EXPECT_EQ(track.morphs, (std::vector<int>{0, 1}));
  EXPECT_EQ(track.weights, (std::vector<float>{0, 0, -2, -2}));
}

TEST(MorphLimits, SayNothingWhereAllAreKept) {
  Model model = model_with_morphs(4);
  EXPECT_EQ(limit_morphs(model), "");
  EXPECT_EQ(model.morphs.size(), 3U) << "one of them moves nothing";
}

TEST(MorphLimits, LeaveNoClipThatDoesNothing) {
  Model model = model_with_morphs(1);
  model.clips.push_back({.name = "bones", .animation = 1, .tracks = model.clips.front().tracks});
  model.clips.front().tracks.clear();
  limit_morphs(model);
  ASSERT_EQ(model.clips.size(), 1U);
  EXPECT_EQ(model.clips.front().name, "bones");
}

TEST(MorphBones, AreThoseThatHoldMostOfWhatAMorphMoves) {
  Model model = model_with_morphs(2);
  SkinnedMesh& mesh = model.meshes.front();
  const auto entry_of = [&](int bone) {
    const auto entry = std::ranges::find(model.skeleton.palette, bone, &PaletteEntry::bone);
    return static_cast<std::uint16_t>(entry - model.skeleton.palette.begin());
  };
  for (glm::u16vec4& entries : mesh.palette_entries) entries = {entry_of(2), entry_of(5), entry_of(3), 0};
  mesh.weights = {{0.5F, 0.25F, 0.25F, 0.0F}, {0.4F, 0.35F, 0.25F, 0.0F}};
  mesh.morph_deltas = {{.vertex = 0, .morph = 0, .position = {}, .normal = {}},
                       {.vertex = 1, .morph = 1, .position = {}, .normal = {}}};
  mesh.palette_entries[1].y = entry_of(3);  // which holds most, by two weights
  EXPECT_EQ(morph_bones(model), (std::vector<int>{2, 3}));
}

TEST(MorphReach, AddsUpWhatMovesAVertexByItsLargestWeight) {
  Model model = model_with_morphs(5);
  EXPECT_NEAR(morph_reach(model), 2.0 * (0.2 + 0.4), 1e-6);
  model.clips.front().morph_tracks.clear();
  EXPECT_EQ(morph_reach(model), 0.0);
}

TEST(MorphReach, CountsWhatASplineBulgesBeyondItsKeys) {
  Model model = model_with_morphs(2);
  MorphTrack& track = model.clips.front().morph_tracks.front();
  track.interpolation = Interpolation::cubic_spline;
  track.weights = {0, 0, 0, 0, 0, 6, 0, -6, 0, 0, 0, 0};  // half way the spline is at 1.5
  EXPECT_GE(morph_reach(model), 1.5 * 0.1);
}

TEST(MorphReach, WidensTheBoundsOfACharacter) {
  const Model morphing = model_with_morphs(5);
  Model plain = morphing;
  plain.morphs.clear();
  plain.meshes.front().morph_deltas.clear();
  plain.clips.front().morph_tracks.clear();
  const Character wide = bake_character(morphing), narrow = bake_character(plain);
  EXPECT_EQ(wide.morph_bones.size(), 5U);
  EXPECT_NEAR(wide.bounds.reach - narrow.bounds.reach, wide.morph_reach, 1e-9);
  EXPECT_GT(wide.morph_reach, 1.0);
  EXPECT_FALSE(wide.clips.front().morphs.empty());
}

}  // namespace
}  // namespace throng::anim::morph_limits_test
