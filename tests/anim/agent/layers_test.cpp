// Channels over channels: the later laid over the earlier, on the bones of a mask, as much as they weigh.

#include <algorithm>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::layers_test {
namespace {

constexpr int walk = 0;
constexpr int wave = 1;

/// The second bone of the trunk and all above it.
BoneMask upper_body() {
  const SubtreeWeight chest{.bone = 1};
  return BoneMask("upper body", test_character()->skeleton, {&chest, 1});
}

CrowdRig playing(int clip) {
  CrowdRig crowd;
  crowd->agent(0).play({.clip = clip});
  return crowd;
}

Status lay(CrowdRig& crowd, int clip, const LayerSettings& settings) {
  return crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = clip}), settings);
}

float distance(const CrowdRig& one, const CrowdRig& other, std::size_t bone) {
  return glm::distance(one.joints()[bone], other.joints()[bone]);
}

TEST(Layer, WithAMaskWavesWhileItWalks) {
  CrowdRig layered = playing(walk);
  const int mask = layered->characters().add_mask(upper_body());
  ASSERT_TRUE(lay(layered, wave, {.mask = mask}));
  CrowdRig walking = playing(walk);
  for (CrowdRig* crowd : {&layered, &walking}) crowd->step(30);
  for (const int bone : layered.bones_unlike(walking)) EXPECT_GT(upper_body().weight(bone), 0.0F) << bone;
  EXPECT_FALSE(layered.bones_unlike(walking).empty());
}

TEST(Layer, OfWholeWeightWithoutAMaskIsAllThatIsSeen) {
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {}));
  CrowdRig waving = playing(wave);
  for (CrowdRig* crowd : {&layered, &waving}) crowd->step(30);
  for (std::size_t bone = 0; bone < layered.joints().size(); ++bone) EXPECT_LT(distance(layered, waving, bone), 1e-5F);
}

TEST(Layer, OfNoWeightIsNotSeen) {
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {.weight = 0.0F}));
  CrowdRig walking = playing(walk);
  for (CrowdRig* crowd : {&layered, &walking}) crowd->step(30);
  for (std::size_t bone = 0; bone < layered.joints().size(); ++bone) EXPECT_LT(distance(layered, walking, bone), 1e-5F);
}

TEST(Layer, MovesWithItsWeight) {
  CrowdRig walking = playing(walk);
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {.weight = 0.0F}));
  float before = 0.0F;
  for (const float weight : {0.25F, 0.5F, 0.75F, 1.0F}) {
    layered->agent(0).set_channel_weight({1}, weight);
    for (CrowdRig* crowd : {&layered, &walking})
      crowd->system->update(std::vector<PoseRequest>{{.agent = {0}, .palette = memory_of(crowd->palette())}});
    float farthest = 0.0F;
    for (std::size_t bone = 0; bone < 40; ++bone) farthest = std::max(farthest, distance(layered, walking, bone));
    EXPECT_GT(farthest, before);
    before = farthest;
  }
}

TEST(Layer, SeveralLieOneOnTopOfTheOther) {
  CrowdRig layered = playing(walk);
  for (const int clip : {2, 3, wave}) ASSERT_TRUE(lay(layered, clip, {}));
  EXPECT_EQ(layered->agent(0).channel_count(), 4U);
  CrowdRig waving = playing(wave);
  for (CrowdRig* crowd : {&layered, &waving}) crowd->step(30);
  for (std::size_t bone = 0; bone < layered.joints().size(); ++bone) EXPECT_LT(distance(layered, waving, bone), 1e-5F);
}

TEST(Layer, FadesBelowGoOn) {
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {.weight = 0.0F}));
  layered->agent(0).play({.clip = 2, .fade = 20 * frame_ticks});
  layered.step(60);
  CrowdRig plain = playing(2);
  plain.step(60);
  for (std::size_t bone = 0; bone < layered.joints().size(); ++bone) EXPECT_LT(distance(layered, plain, bone), 1e-5F);
}

TEST(Layer, ThatIsRemovedGivesItsEntitiesBack) {
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {}));
  ASSERT_TRUE(lay(layered, 3, {.weight = 0.5F}));
  CrowdRig walking = playing(walk);
  for (CrowdRig* crowd : {&layered, &walking}) crowd->step(10);
  layered->agent(0).remove_channel({2});
  layered->agent(0).remove_channel({1});
  for (CrowdRig* crowd : {&layered, &walking}) crowd->step();
  EXPECT_TRUE(layered.bones_unlike(walking).empty());
  EXPECT_EQ(layered->characters().pools(0).pool(EntityPools::ease_blenders).alive_count(), 0U);
  EXPECT_EQ(layered->characters().pools(0).pool(EntityPools::sampled_players).alive_count(), 1U);
}

TEST(Layer, TheFirstMayBeRemovedToo) {
  CrowdRig layered = playing(walk);
  ASSERT_TRUE(lay(layered, wave, {.weight = 0.5F}));
  layered->agent(0).remove_channel({0});
  CrowdRig waving = playing(wave);
  for (CrowdRig* crowd : {&layered, &waving}) crowd->step(10);
  EXPECT_TRUE(layered.bones_unlike(waving).empty());
  EXPECT_EQ(layered.entities(), 1U);
}

TEST(Layer, WhoseGraphHasACycleIsRefusedAndTheAgentIsAsItWas) {
  CrowdRig crowd = playing(walk);
  CrowdRig plain = playing(walk);
  const Status added = crowd->agent(0).add_channel(std::make_unique<FixedChannel>([](const EntityBuilder& build) {
    const Handle player = build.player({.clip = wave});
    const Handle blender = build.hold(player, player, 0.5F);
    build.as<EaseBlender>(blender).to = blender;
    return std::vector{player, blender};
  }));
  ASSERT_FALSE(added);
  EXPECT_THAT(added.error().message, testing::HasSubstr("is among its own sources"));
  EXPECT_EQ(crowd->agent(0).channel_count(), 1U);
  EXPECT_EQ(crowd->characters().pools(0).pool(EntityPools::ease_blenders).alive_count(), 0U);
  for (CrowdRig* one : {&crowd, &plain}) one->step(10);
  EXPECT_TRUE(crowd.bones_unlike(plain).empty());
  crowd->agent(0).play({.clip = 2, .fade = frame_ticks});
  crowd.step(5);
}

TEST(Layer, ThatAStoreOfFixedSizeHasNoRoomForIsRefusedAndTheAgentIsAsItWas) {
  CrowdRig crowd({.local_store_bytes = 16 * 1024});
  crowd->agent(0).play({.clip = walk});
  CrowdRig plain = playing(walk);
  std::size_t layers = 1;
  Status added = Done{};
  while ((added = lay(crowd, wave, {.weight = 0.0F}))) ASSERT_LT(++layers, 32U);
  EXPECT_THAT(added.error().message, testing::HasSubstr("the smallest that works is"));
  EXPECT_EQ(crowd->agent(0).channel_count(), layers);
  for (CrowdRig* one : {&crowd, &plain}) one->step(10);
  for (std::size_t bone = 0; bone < 40; ++bone) EXPECT_LT(distance(crowd, plain, bone), 1e-5F);
}

TEST(Layer, MakesAnAutomaticStoreGrow) {
  CrowdRig crowd({.stream = StreamKind::keyframe});
  crowd->agent(0).play({.clip = walk});
  const std::size_t before = crowd->figures().schedule().local_store_bytes;
  for (int layer = 1; layer < 20; ++layer) {
    const Status added = lay(crowd, layer % 5, {.weight = 0.5F});
    ASSERT_TRUE(added) << added.error().message;
  }
  crowd.step(10);
  EXPECT_GT(crowd->figures().schedule().local_store_bytes, before);
}

}  // namespace
}  // namespace throng::anim::layers_test
