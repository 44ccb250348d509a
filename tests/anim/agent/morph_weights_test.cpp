// What the clips that an agent plays do to its morphs.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/entity/additive_layer.h"
#include "engine/anim/entity/mixer.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::morph_weights_test {
namespace {

MorphTrack track_of(std::vector<int> morphs, std::vector<float> weights) {
  return {.interpolation = Interpolation::linear,
          .morphs = std::move(morphs),
          .times = {0.0F, 1.0F},
          .weights = std::move(weights)};
}

int bone_of(const std::string& name) { return find_bone(marching_person().skeleton, name); }

/// The marching person, who opens the first of two morphs within a second as it marches; swaying holds the second half
/// open, and the third clip has none. The first is of the head, the second of a foot.
std::shared_ptr<const Character> morphing_person() {
  Model model = marching_person();
  model.morphs.resize(2);
  SkinnedMesh& mesh = model.meshes.emplace_back();
  for (const char* const name : {"head", "foot.L"}) {
    const auto entry = std::ranges::find(model.skeleton.palette, bone_of(name), &PaletteEntry::bone);
    const auto index = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(0.0F, 1.0F, 0.0F);
    mesh.normals.emplace_back(0.0F, 1.0F, 0.0F);
    mesh.palette_entries.emplace_back(entry - model.skeleton.palette.begin(), 0, 0, 0);
    mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
    mesh.morph_deltas.push_back({.vertex = index, .morph = index, .position = {0.0F, 0.1F, 0.0F}, .normal = {}});
  }
  model.clips.push_back(model.clips[1]);
  model.clips[0].morph_tracks = {track_of({0}, {0.0F, 1.0F})};
  model.clips[1].morph_tracks = {track_of({0, 1}, {0.0F, 0.5F, 0.0F, 0.5F})};
  return std::make_shared<const Character>(bake_character(model));
}

class MorphWeights : public testing::Test {
 protected:
  MorphWeights() : system_(std::move(*AnimationSystem::create(morphing_person(), {.pus = 1}))) {
    system_->set_agent_count(1);
  }
  Agent agent() { return system_->agent(0); }
  void advance(double seconds, double look_ahead = 0.0) {
    system_->advance(to_ticks(seconds));
    const PoseRequest update{.agent = {0}, .look_ahead = to_ticks(look_ahead)};
    system_->update({&update, 1});
  }
  void skip(double seconds) { system_->advance(to_ticks(seconds)); }
  std::vector<float> weights() {
    std::vector<float> now(2, 0.0F);
    plays_ = agent().motion().add_morph_weights(system_->clock(), now);
    return now;
  }
  void expect(float first, float second) {
    const std::vector<float> now = weights();
    EXPECT_NEAR(now[0], first, 1e-5F);
    EXPECT_NEAR(now[1], second, 1e-5F);
  }

  std::unique_ptr<AnimationSystem> system_;
  bool plays_ = false;
};

TEST_F(MorphWeights, FollowTheClipAndWrapWithIt) {
  agent().play({.clip = 0});
  advance(0.25);
  expect(0.25F, 0.0F);
  advance(1.5);
  expect(0.75F, 0.0F);
}

TEST_F(MorphWeights, HoldTheEndOfAClipThatDoesNotLoop) {
  agent().play({.clip = 0, .loop = false});
  advance(1.5);
  expect(1.0F, 0.0F);
}

TEST_F(MorphWeights, AreThoseOfNowWhetherTheAgentIsPosedAheadOrNotAtAll) {
  agent().play({.clip = 0});
  advance(0.25, 0.2);
  expect(0.25F, 0.0F);
  skip(0.5);
  expect(0.75F, 0.0F);
}

TEST_F(MorphWeights, FadeWithThePose) {
  agent().play({.clip = 0});
  advance(0.25);
  agent().play({.clip = 1, .fade = to_ticks(0.5)});
  advance(0.125);  // a quarter of the fade, which eases in
  const float share = 0.25F * 0.25F * (3.0F - 2.0F * 0.25F);
  expect((1.0F - share) * 0.375F, share * 0.5F);
  skip(0.125);
  expect(0.5F * 0.5F, 0.5F * 0.5F);
  advance(0.5);
  expect(0.0F, 0.5F);
}

TEST_F(MorphWeights, AreLaidOverByAMaskAsTheirBonesAre) {
  const SubtreeWeight head{.bone = bone_of("head"), .weight = 0.5F};
  const int mask = system_->characters().add_mask(BoneMask("head", marching_person().skeleton, {&head, 1}));
  agent().play({.clip = 0});
  advance(0.25);
  expect(0.25F, 0.0F);
  agent().play({.clip = 1, .mask = mask});
  advance(0.25);
  expect(0.5F * 0.5F, 0.0F);  // the foot's is not masked, so marching alone counts
  EXPECT_EQ(agent().motion().weights(system_->clock())[0] + agent().motion().weights(system_->clock())[1], 1.0F)
      << "root motion knows no masks";
}

TEST_F(MorphWeights, AreMixedAsTheirBonesAre) {
  const SubtreeWeight trunk{.bone = bone_of("head"), .weight = 0.25F};
  const int mask = system_->characters().add_mask(BoneMask("head", marching_person().skeleton, {&trunk, 1}));
  const auto make = [&](const EntityBuilder& build) {
    const Handle march = build.player({.clip = 0, .speed = 0.0, .start = to_ticks(0.5)});
    const Handle sway = build.player({.clip = 1});
    const Handle mixed = build.create(EntityPools::mixers);
    build.as<Mixer>(mixed).source_count = 2;
    std::ranges::fill(build.as<Mixer>(mixed).masks, EaseBlender::no_mask);
    build.as<Mixer>(mixed).masks[1] = static_cast<std::int16_t>(mask);
    build.private_as<MixerSources>(mixed) = {.sources = {march, sway}, .weights = {1.0F, 4.0F}};
    return std::vector<Handle>{march, sway, mixed};
  };
  ASSERT_TRUE(agent().add_channel(std::make_unique<FixedChannel>(make)));
  advance(0.1);
  expect(0.5F * 0.5F, 0.0F);  // at the head swaying has half, at the foot nothing
}

TEST_F(MorphWeights, AreAddedByAnAdditiveLayer) {
  const auto make = [](const EntityBuilder& build) {
    const Handle march = build.player({.clip = 0});
    const Handle sway = build.player({.clip = 1});
    const Handle reference = build.player({.clip = 0, .speed = 0.0, .start = to_ticks(0.5)});
    const Handle layer = build.create(EntityPools::additive_layers);
    auto& additive = build.as<AdditiveLayer>(layer);
    additive.base = march;
    additive.layer = sway;
    additive.reference = reference;
    additive.weight = additive.target_weight = 0.5F;
    additive.mask = EaseBlender::no_mask;
    return std::vector<Handle>{march, sway, reference, layer};
  };
  ASSERT_TRUE(agent().add_channel(std::make_unique<FixedChannel>(make)));
  advance(0.75);
  expect(0.75F - 0.5F * 0.5F, 0.5F * 0.5F);
}

TEST_F(MorphWeights, AreNotAskedForOfAClipWithoutMorphs) {
  agent().play({.clip = 2});
  advance(0.1);
  expect(0.0F, 0.0F);
  EXPECT_FALSE(plays_);
  agent().play({.clip = 0});
  expect(0.0F, 0.0F);
  EXPECT_TRUE(plays_);
}

}  // namespace
}  // namespace throng::anim::morph_weights_test
