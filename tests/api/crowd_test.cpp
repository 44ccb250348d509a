// Agents and characters come, are posed, and go.

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::crowd_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;

TEST(Api, PosesAreTheSameForAnyNumberOfPusAndAnyExecutor) {
  InOrder in_order;
  std::uint64_t hashes[3];
  CrowdOptions options[3] = {{.pus = 1}, {.pus = 3}, {.pus = 4, .executor = &in_order}};
  for (int i = 0; i < 3; ++i) {
    ApiCrowd crowd(50, options[i]);
    for (std::uint32_t agent = 0; agent < 50; ++agent) {
      crowd.agent(agent).play({.clip = {agent % mannequin().clip_count()}});
    }
    crowd.step(30);
    hashes[i] = crowd.hash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

TEST(Api, AnIdOfWhoIsGoneIsRefused) {
  const HeardMisuses heard;
  ApiCrowd crowd(2);
  const AgentId gone = crowd->agents()[0];
  EXPECT_TRUE(crowd->remove_agent(gone));
  const AgentId heir = crowd->add_agent();
  EXPECT_EQ(heir.number, gone.number) << "numbers are used again";
  EXPECT_FALSE(crowd->agent(gone).play({.clip = {0}}));
  EXPECT_FALSE(crowd->agent(gone).add(LookAt{}));
  EXPECT_FALSE(crowd->remove_agent(gone));
  EXPECT_EQ(heard.all().size(), 3U);
  EXPECT_TRUE(crowd->agent(heir).play({.clip = {0}}));
}

TEST(Api, CharactersJoinACrowdThatPlaysAndLeaveIt) {
  ApiCrowd crowd(3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) crowd.agent(agent).play({.clip = {1}});
  crowd.step(5);
  const auto guest = crowd->add(mannequin());
  ASSERT_TRUE(guest);
  const AgentId agent = crowd->add_agent(*guest);
  EXPECT_TRUE(crowd->agent(agent).play({.clip = {2}}));
  crowd.step(5);
  EXPECT_FALSE(crowd->remove(*guest)) << "an agent plays it";
  crowd->remove_agent(agent);
  EXPECT_TRUE(crowd->remove(*guest));
  EXPECT_FALSE(crowd->character(*guest));
  crowd.step(5);
  EXPECT_EQ(crowd->debug().posed_agents(), 3U);
}

TEST(Api, ASnapshotGoesOnToTheSamePoses) {
  ApiCrowd crowd(20);
  for (std::uint32_t agent = 0; agent < 20; ++agent) crowd.agent(agent).play({.clip = {agent % 5}});
  crowd.step(10);
  crowd.agent(3).play({.clip = {0}, .fade = to_ticks(0.5)});
  Snapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(40);
  const std::uint64_t hash = crowd.hash();
  ASSERT_TRUE(crowd->restore(snapshot));
  crowd.step(40);
  EXPECT_EQ(crowd.hash(), hash);
}

TEST(Api, ASnapshotOfAnotherCrowdIsAMisuse) {
  ApiCrowd one(3), other(3);
  Snapshot snapshot;
  one->snapshot(snapshot);
  const HeardMisuses heard;
  const Result<Done> restored = other->restore(snapshot);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().message, "Crowd::restore: the snapshot is of another crowd");
  EXPECT_EQ(heard.all().size(), 1U);
  EXPECT_TRUE(one->restore(snapshot));
}

TEST(Api, AStartBeyondTheClipIsAMisuse) {
  ApiCrowd crowd(1);
  const ClipId walk = mannequin().find_clip("walk");
  const Ticks duration = mannequin().clip(walk).duration;
  const auto clips = crowd.agent(0).add_clips();
  ASSERT_TRUE(clips);
  EXPECT_TRUE(crowd.agent(0).play({.clip = walk, .start = duration}));
  const HeardMisuses heard;
  for (const Ticks start : {duration + ticks_per_second / 500, Ticks{-1}}) {
    EXPECT_FALSE(crowd.agent(0).play({.clip = walk, .start = start}));
    EXPECT_FALSE(crowd.agent(0).play(*clips, {.clip = walk, .start = start}));
  }
  EXPECT_EQ(heard.all().size(), 4U);
}

TEST(Api, ALayerWavesOnTheBonesOfItsMask) {
  ApiCrowd crowd(2);
  const int arm = *mannequin().find_bone("upper_arm.R");
  const BoneWeight weight{.bone = arm};
  const MaskId mask = crowd->add_mask(0, {&weight, 1});
  ASSERT_TRUE(mask.valid());
  for (std::uint32_t agent = 0; agent < 2; ++agent) crowd.agent(agent).play({.clip = mannequin().find_clip("walk")});
  const auto layer = crowd.agent(1).add_clips({.mask = mask});
  ASSERT_TRUE(layer);
  EXPECT_TRUE(crowd.agent(1).play(*layer, {.clip = mannequin().find_clip("wave")}));
  crowd.step(30);
  const auto differs = [&](int bone) {
    const float* const one = crowd.palette({.number = 0}) + std::size_t{12} * static_cast<std::size_t>(bone);
    const float* const other = crowd.palette({.number = 1}) + std::size_t{12} * static_cast<std::size_t>(bone);
    return !std::equal(one, one + 12, other);
  };
  EXPECT_TRUE(differs(arm));
  EXPECT_FALSE(differs(*mannequin().find_bone("foot.L")));
}

TEST(Api, RefusesAMaskThatIsNone) {
  const HeardMisuses heard;
  ApiCrowd crowd(1);
  const BoneWeight beyond{.bone = 1000};
  const BoneWeight heavy{.bone = 1, .weight = 2.0F};
  EXPECT_FALSE(crowd->add_mask(0, {&beyond, 1}).valid());
  EXPECT_FALSE(crowd->add_mask(0, {&heavy, 1}).valid());
  EXPECT_FALSE(crowd->add_mask(7, {}).valid());
  EXPECT_EQ(heard.all().size(), 3U);
}

TEST(Api, AnEmptyCharacterIsRefused) {
  const HeardMisuses heard;
  EXPECT_FALSE(Crowd::create(Character()));
  ApiCrowd crowd(1);
  EXPECT_FALSE(crowd->add(Character()));
  EXPECT_EQ(heard.all().size(), 2U);
}

TEST(Api, ItsVersionIsThatOfItsHeaders) {
  EXPECT_EQ(version(), THRONG_VERSION);
  EXPECT_STREQ(version_text(), "1.0.0");
}

}  // namespace
}  // namespace throng::crowd_test
