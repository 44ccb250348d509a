#include <algorithm>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/base/pose.h"

namespace throng::anim::bone_masks_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int bones = 40;
constexpr int under = 0;  // the clip below
constexpr int over = 1;   // the clip laid over it

std::shared_ptr<const Character> character() {
  static const auto baked = std::make_shared<const Character>(bake_character(synthetic_model(bones, 3)));
  return baked;
}

/// One agent; `levels` keeps poses where they can be looked at.
struct Solo {
  explicit Solo(Schedule schedule = Schedule::levels)
      : system(std::move(*AnimationSystem::create(character(), {.schedule = schedule}))) {
    system->set_agent_count(1);
  }
  void step(int frames = 1) {
    const PoseRequest update{.agent = {0}};
    for (int i = 0; i < frames; ++i) {
      system->advance(frame);
      system->update({&update, 1});
    }
  }
  std::vector<float> bone(int index) const {
    const int components = character()->skeleton.components();
    const float* const packet =
        system->agent(0).pose().data() + index / packet_bones * components * packet_bones + index % packet_bones;
    std::vector<float> values;
    for (int component = 0; component < components; ++component) values.push_back(packet[component * packet_bones]);
    return values;
  }
  std::unique_ptr<AnimationSystem> system;
};

/// Plays one clip alone, as long as the blends it is compared with.
Solo playing(int clip, int frames) {
  Solo solo;
  solo.system->agent(0).play({.clip = clip});
  solo.step(frames);
  return solo;
}

/// One bone and all below it.
BoneMask arm(float weight = 1.0F) {
  const SubtreeWeight subtree{.bone = bones / 4, .weight = weight};
  return BoneMask("arm", character()->skeleton, {&subtree, 1});
}

void expect_each_bone_from_its_clip(const Solo& masked, const BoneMask& mask, int frames) {
  const Solo below = playing(under, frames);
  const Solo above = playing(over, frames);
  int masked_bones = 0;
  for (int bone = 0; bone < bones; ++bone) {
    const bool is_masked = mask.weight(bone) > 0.0F;
    masked_bones += is_masked ? 1 : 0;
    EXPECT_NE(below.bone(bone), above.bone(bone)) << "a bone that both clips move alike shows nothing: " << bone;
    EXPECT_EQ(masked.bone(bone), (is_masked ? above : below).bone(bone)) << bone;
  }
  EXPECT_GT(masked_bones, 0);
  EXPECT_LT(masked_bones, bones);
}

TEST(MaskedBlend, GivesWeighedBonesTheSecondClipAndLeavesTheOthersTheirBits) {
  Solo solo;
  const int mask = solo.system->characters().add_mask(arm());
  solo.system->agent(0).play({.clip = under});
  solo.system->agent(0).play({.clip = over, .held_fraction = 1.0F, .mask = mask});
  solo.step(7);
  expect_each_bone_from_its_clip(solo, arm(), 7);
}

TEST(MaskedBlend, WithoutAFadeIsThereAtOnceAndStays) {
  Solo solo;
  const int mask = solo.system->characters().add_mask(arm());
  solo.system->agent(0).play({.clip = under});
  solo.system->agent(0).play({.clip = over, .mask = mask});
  solo.step(90);
  expect_each_bone_from_its_clip(solo, arm(), 90);
}

TEST(MaskedBlend, EasesInOnTheMaskedBonesAloneAndStaysWhenTheFadeIsOver) {
  Solo solo;
  const int mask = solo.system->characters().add_mask(arm());
  solo.system->agent(0).play({.clip = under});
  solo.system->agent(0).play({.clip = over, .fade = 10 * frame, .mask = mask});
  solo.step(5);
  const Solo below = playing(under, 5);
  const Solo above = playing(over, 5);
  for (int bone = 0; bone < bones; ++bone) {
    if (arm().weight(bone) > 0.0F) {
      EXPECT_NE(solo.bone(bone), below.bone(bone)) << bone;
      EXPECT_NE(solo.bone(bone), above.bone(bone)) << bone;
    } else {
      EXPECT_EQ(solo.bone(bone), below.bone(bone)) << bone;
    }
  }
  solo.step(20);
  expect_each_bone_from_its_clip(solo, arm(), 25);
}

TEST(MaskedBlend, GoesWithTheNextFadeWithoutAMask) {
  Solo solo;
  const int mask = solo.system->characters().add_mask(arm());
  solo.system->agent(0).play({.clip = 2});
  solo.system->agent(0).play({.clip = over, .mask = mask});
  solo.step();
  solo.system->agent(0).play({.clip = under, .fade = 5 * frame});
  solo.step(10);
  const Solo below = playing(under, 10);
  for (int bone = 0; bone < bones; ++bone) EXPECT_EQ(solo.bone(bone), below.bone(bone)) << bone;
}

TEST(MaskedBlend, UsesTheMaskThatIsNamed) {
  Solo solo;
  solo.system->characters().add_mask(arm(0.0F));
  const int mask = solo.system->characters().add_mask(arm());
  solo.system->agent(0).play({.clip = under});
  solo.system->agent(0).play({.clip = over, .mask = mask});
  solo.step(3);
  expect_each_bone_from_its_clip(solo, arm(), 3);
}

TEST(MaskedBlend, IsTheSamePoseUnderBothSchedules) {
  Solo levels(Schedule::levels);
  Solo fused(Schedule::fused);
  Solo unmasked(Schedule::fused);
  for (Solo* solo : {&levels, &fused}) {
    const int mask = solo->system->characters().add_mask(arm(0.7F));
    solo->system->agent(0).play({.clip = under});
    solo->system->agent(0).play({.clip = over, .fade = 10 * frame, .mask = mask});
    solo->step(20);
  }
  unmasked.system->agent(0).play({.clip = under});
  unmasked.system->agent(0).play({.clip = over, .fade = 10 * frame});
  unmasked.step(20);
  EXPECT_EQ(levels.system->figures().pose_hash(), fused.system->figures().pose_hash());
  EXPECT_NE(levels.system->figures().pose_hash(), unmasked.system->figures().pose_hash());
}

TEST(MaskedBlend, WeighsTheSameBonesWhenTheyGetAnotherOrder) {
  Solo solo;
  const int mask = solo.system->characters().add_mask(arm());
  int inside = bones - 1, outside = bones - 1;
  while (arm().weight(inside) == 0.0F) --inside;
  while (arm().weight(outside) > 0.0F) --outside;
  std::vector<int> places(bones);
  std::iota(places.begin(), places.end(), 0);
  std::swap(places[static_cast<std::size_t>(inside)], places[static_cast<std::size_t>(outside)]);
  ASSERT_TRUE(solo.system->characters().replace(0, character(), places));
  solo.system->agent(0).play({.clip = under});
  solo.system->agent(0).play({.clip = over, .held_fraction = 1.0F, .mask = mask});
  solo.step(2);
  EXPECT_EQ(solo.bone(bones / 4), playing(over, 2).bone(bones / 4));
  EXPECT_EQ(solo.bone(outside), playing(over, 2).bone(outside)) << "the bone of the arm is there now";
  EXPECT_EQ(solo.bone(inside), playing(under, 2).bone(inside));
}

}  // namespace
}  // namespace throng::anim::bone_masks_test
