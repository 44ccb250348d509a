// What the clips that an agent plays give to its curves.

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/model_check.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::curves_test {
namespace {

constexpr std::uint32_t glow = 0;
constexpr std::uint32_t aim = 1;

/// The marching person glows more and more for a second; swaying glows by 0.5 and aims. A third clip does neither.
Model glowing_model() {
  Model model = marching_person();
  model.clips.push_back(model.clips[1]);
  model.clips[0].curves = {{.name = "glow", .times = {0.0F, 1.0F}, .values = {0.0F, 1.0F}}};
  model.clips[1].curves = {{.name = "glow", .times = {0.0F}, .values = {0.5F}},
                           {.name = "aim", .times = {0.0F}, .values = {2.0F}}};
  return model;
}

class Curves : public testing::Test {
 protected:
  Curves() {
    const auto character = std::make_shared<const Character>(bake_character(glowing_model()));
    system_ = std::move(*AnimationSystem::create(character, {.pus = 1}));
    system_->set_agent_count(1);
  }
  Agent agent() { return system_->agent(0); }
  float curve(std::uint32_t name) { return agent().motion().curve(name, system_->clock()); }
  void pass(double seconds) { system_->advance(to_ticks(seconds)); }

  std::unique_ptr<AnimationSystem> system_;
};

TEST(CurveNames, OfAllClipsAreEachThereOnce) {
  EXPECT_EQ(bake_character(glowing_model()).curve_names, (std::vector<std::string>{"glow", "aim"}));
}

TEST(CurveNames, OfAModelThatIsBuiltWrongAreRefused) {
  Model model = glowing_model();
  model.clips[0].curves[0].values.pop_back();
  EXPECT_FALSE(check_model(model));
  model = glowing_model();
  model.clips[1].curves[1].name = "glow";
  EXPECT_FALSE(check_model(model)) << "two of a name";
}

TEST(CurvesOfPoses, DoNotChangeThem) {
  Model plain = glowing_model();
  for (Clip& clip : plain.clips) clip.curves.clear();
  std::uint64_t hashes[2];
  for (int i = 0; i < 2; ++i) {
    const auto character = std::make_shared<const Character>(bake_character(i == 0 ? plain : glowing_model()));
    auto system = AnimationSystem::create(character, {.pus = 1});
    ASSERT_TRUE(system);
    (*system)->set_agent_count(1);
    (*system)->agent(0).play({.clip = 0});
    const PoseRequest update{.agent = {0}};
    for (int frame = 0; frame < 10; ++frame) {
      (*system)->advance(frame_ticks);
      (*system)->update({&update, 1});
    }
    hashes[i] = (*system)->figures().pose_hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_F(Curves, FollowTheClipWhetherItIsPosedOrNot) {
  agent().play({.clip = 0});
  pass(0.25);
  EXPECT_NEAR(curve(glow), 0.25F, 1e-4F);
  EXPECT_EQ(curve(aim), 0.0F) << "this clip has none of this name";
}

TEST_F(Curves, AreBlendedByTheWeightsOfTheClips) {
  agent().play({.clip = 2});
  agent().play({.clip = 1, .held_fraction = 0.25F});
  EXPECT_NEAR(curve(glow), 0.125F, 1e-6F);
  EXPECT_NEAR(curve(aim), 0.5F, 1e-6F);
}

TEST_F(Curves, FadeWithTheirClips) {
  agent().play({.clip = 2});
  agent().play({.clip = 1, .fade = to_ticks(1.0)});
  EXPECT_EQ(curve(aim), 0.0F);
  pass(0.5);
  EXPECT_NEAR(curve(aim), 1.0F, 1e-5F);
  pass(0.5);
  EXPECT_NEAR(curve(aim), 2.0F, 1e-5F);
}

TEST_F(Curves, UnderAMaskAreFeltWhole) {
  const SubtreeWeight chest{.bone = 1};
  const int mask = system_->characters().add_mask(BoneMask("chest", marching_person().skeleton, {&chest, 1}));
  agent().play({.clip = 2});
  ASSERT_TRUE(agent().add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}), {.mask = mask}));
  EXPECT_NEAR(curve(aim), 2.0F, 1e-6F);
}

TEST_F(Curves, OfAClipBesideItselfUnderAMaskAreTheirMean) {
  const SubtreeWeight chest{.bone = 1};
  const int mask = system_->characters().add_mask(BoneMask("chest", marching_person().skeleton, {&chest, 1}));
  agent().play({.clip = 1});
  ASSERT_TRUE(agent().add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}), {.mask = mask}));
  EXPECT_NEAR(curve(aim), 2.0F, 1e-6F) << "not twice as much";
}

TEST_F(Curves, OfNobodyAreNone) {
  EXPECT_EQ(curve(glow), 0.0F);
  agent().play({.clip = 1});
  EXPECT_EQ(curve(99), 0.0F);
}

}  // namespace
}  // namespace throng::anim::curves_test
