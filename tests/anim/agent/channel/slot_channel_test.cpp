// One-shots over a walk: they come, are seen, and are gone, all by themselves.

#include "engine/anim/agent/channel/slot_channel.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::anim::slot_channel_test {
namespace {

constexpr Ticks fade = 12 * frame_ticks;
constexpr ChannelId slot{1};

CrowdRig walking() {
  CrowdRig crowd;
  crowd->agent(0).play({.clip = 0});
  return crowd;
}

/// A walk under a slot that plays nothing yet.
CrowdRig with_slot(const LayerSettings& settings = {}) {
  CrowdRig crowd = walking();
  EXPECT_TRUE(crowd->agent(0).add_channel(std::make_unique<SlotChannel>(), settings));
  return crowd;
}

bool play(CrowdRig& crowd, const OneShot& shot) {
  bool taken = false;
  const auto ask = [&](SlotChannel& own) { taken = own.play(shot); };
  return crowd->agent(0).change<SlotChannel>(slot, ask).has_value() && taken;
}

const SlotChannel& channel(const CrowdRig& crowd) { return *crowd->agent(0).channel<SlotChannel>(slot); }

/// Returns the frames that a clip takes, the one in which it ends included.
int frames_of(int clip) {
  const Ticks duration = test_character()->clips[static_cast<std::size_t>(clip)].duration;
  return static_cast<int>((duration + frame_ticks - Ticks{1}) / frame_ticks);
}

float distance(const CrowdRig& one, const CrowdRig& other) {
  float farthest = 0.0F;
  for (std::size_t bone = 0; bone < one.joints().size(); ++bone) {
    farthest = std::max(farthest, glm::distance(one.joints()[bone], other.joints()[bone]));
  }
  return farthest;
}

TEST(Slot, PlaysNothingUntilItIsAskedTo) {
  CrowdRig crowd = with_slot();
  CrowdRig plain = walking();
  for (CrowdRig* one : {&crowd, &plain}) one->step(5);
  EXPECT_TRUE(crowd.bones_unlike(plain).empty());
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(Slot, FadesInPlaysFadesOutAndIsGone) {
  CrowdRig crowd = with_slot();
  CrowdRig plain = walking();
  CrowdRig alone;
  alone->agent(0).play({.clip = 1, .loop = false});
  ASSERT_TRUE(play(crowd, {.clip = 1, .fade_in = fade, .fade_out = fade}));
  std::vector<float> distances;
  for (int frame = 1; frame <= frames_of(1); ++frame) {
    for (CrowdRig* one : {&crowd, &plain, &alone}) one->step();
    distances.push_back(distance(crowd, plain));
    if (frame == frames_of(1) / 2) {
      EXPECT_LT(distance(crowd, alone), 1e-5F) << "nothing but the shot is seen";
    }
    EXPECT_EQ(channel(crowd).is_playing(crowd->clock()), frame < frames_of(1));
  }
  const float largest = *std::ranges::max_element(distances);
  EXPECT_LT(distances.front(), 0.1F * largest);
  EXPECT_LT(distances[distances.size() - 2], 0.1F * largest);
  EXPECT_TRUE(crowd.bones_unlike(plain).empty());
  EXPECT_EQ(crowd.entities(), 1U) << "it costs what it did before";
}

TEST(Slot, CutsWithoutFades) {
  CrowdRig crowd = with_slot();
  CrowdRig alone;
  alone->agent(0).play({.clip = 1, .loop = false});
  ASSERT_TRUE(play(crowd, {.clip = 1}));
  for (int frame = 1; frame < frames_of(1); ++frame) {
    for (CrowdRig* one : {&crowd, &alone}) one->step();
    ASSERT_LT(distance(crowd, alone), 1e-5F) << frame;
  }
}

TEST(Slot, PlaysBackwardsFromTheEnd) {
  CrowdRig crowd = with_slot();
  const Ticks duration = test_character()->clips[1].duration;
  CrowdRig alone;
  alone->agent(0).play({.clip = 1, .speed = -2.0, .start = duration, .loop = false});
  ASSERT_TRUE(play(crowd, {.clip = 1, .speed = -2.0}));
  EXPECT_TRUE(channel(crowd).is_playing(duration / 2 - frame_ticks));
  EXPECT_FALSE(channel(crowd).is_playing(duration / 2 + Ticks{1}));
  for (CrowdRig* one : {&crowd, &alone}) one->step(10);
  EXPECT_LT(distance(crowd, alone), 1e-5F);
}

TEST(Slot, WithAMaskLeavesTheOtherBonesAlone) {
  CrowdRig crowd = walking();
  const SubtreeWeight chest{.bone = 1};
  const BoneMask upper("upper body", test_character()->skeleton, {&chest, 1});
  const int mask = crowd->characters().add_mask(BoneMask("upper body", test_character()->skeleton, {&chest, 1}));
  ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<SlotChannel>(), {.mask = mask}));
  CrowdRig plain = walking();
  ASSERT_TRUE(play(crowd, {.clip = 1, .fade_in = fade, .fade_out = fade}));
  for (CrowdRig* one : {&crowd, &plain}) one->step(frames_of(1) / 2);
  EXPECT_FALSE(crowd.bones_unlike(plain).empty());
  for (const int bone : crowd.bones_unlike(plain)) EXPECT_GT(upper.weight(bone), 0.0F) << bone;
}

TEST(Slot, PlaysWhatIsQueuedAfterTheOneThatPlays) {
  CrowdRig crowd = with_slot();
  ASSERT_TRUE(play(crowd, {.clip = 1, .fade_in = fade, .fade_out = fade}));
  ASSERT_TRUE(play(crowd, {.clip = 2, .fade_in = fade, .fade_out = fade, .queued = true}));
  const int second_begins = frames_of(1) - 12;
  crowd.step(second_begins + frames_of(2) / 2);
  CrowdRig alone;
  alone->agent(0).play({.clip = 2, .loop = false});
  const Ticks into = crowd->clock() - (test_character()->clips[1].duration - fade);
  alone->advance(into - frame_ticks);
  alone.step();
  EXPECT_LT(distance(crowd, alone), 1e-4F);
  crowd.step(frames_of(2));
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(Slot, RefusesMoreThanFourAtATime) {
  CrowdRig crowd = with_slot();
  for (int shot = 0; shot < 4; ++shot) EXPECT_TRUE(play(crowd, {.clip = 1, .queued = true}));
  EXPECT_FALSE(play(crowd, {.clip = 1, .queued = true}));
  EXPECT_FALSE(channel(crowd).took_all());
  EXPECT_TRUE(play(crowd, {.clip = 1})) << "this one takes the place of all";
}

/// Asks two crowds for the same, and poses one of them in each frame.
struct Pair {
  CrowdRig each_frame = with_slot();
  CrowdRig seldom = with_slot();

  void ask(const OneShot& shot) {
    ASSERT_TRUE(play(each_frame, shot));
    ASSERT_TRUE(play(seldom, shot));
  }
};

TEST(Slot, DoesNotDependOnWhichFramesArePosed) {
  Pair pair;
  pair.ask({.clip = 1, .fade_in = fade, .fade_out = fade});
  for (const int clip : {2, 3}) pair.ask({.clip = clip, .fade_in = fade, .fade_out = fade, .queued = true});
  for (int frame = 0; frame < frames_of(1) + frames_of(2) + frames_of(3); frame += 7) {
    pair.each_frame.step(7);
    pair.seldom->advance(6 * frame_ticks);
    pair.seldom.step();
    ASSERT_TRUE(pair.each_frame.bones_unlike(pair.seldom).empty()) << frame;
  }
  EXPECT_EQ(pair.seldom.entities(), 1U);
}

TEST(Slot, IsTheSameForWhoIsPosedAheadOfTheClock) {
  Pair pair;
  pair.ask({.clip = 1, .fade_in = fade, .fade_out = fade});
  for (int frame = 0; frame < frames_of(1) + frames_of(2); frame += 20) {
    const PoseRequest early{.agent = {0}, .look_ahead = 20 * frame_ticks, .palette = memory_of(pair.seldom.palette())};
    pair.seldom->update({&early, 1});
    pair.each_frame.step(10);
    pair.seldom->advance(10 * frame_ticks);
    if (frame == 0) pair.ask({.clip = 2, .fade_in = fade, .fade_out = fade, .queued = true});  // it stands ahead
    pair.each_frame.step(10);
    pair.seldom->advance(10 * frame_ticks);
    ASSERT_TRUE(pair.each_frame.bones_unlike(pair.seldom).empty()) << frame;
  }
}

TEST(Slot, GoesOnAfterASnapshot) {
  CrowdRig crowd = with_slot();
  play(crowd, {.clip = 1, .fade_in = fade, .fade_out = fade});
  play(crowd, {.clip = 2, .fade_in = fade, .queued = true});
  crowd.step(10);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(100);
  const std::uint64_t hash = crowd->figures().pose_hash();
  ASSERT_TRUE(crowd->restore(snapshot));
  crowd.step(100);
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
}

/// Interrupts shots now and then and returns the farthest step of a joint from frame to frame.
float largest_step(int frames_between, Ticks fade_in) {
  CrowdRig crowd = with_slot();
  float largest = 0.0F;
  std::vector<glm::vec3> before;
  for (int frame = 0; frame < 200; ++frame) {
    if (frame % frames_between == 0)
      play(crowd, {.clip = 1 + frame / frames_between % 4, .fade_in = fade_in, .fade_out = fade});
    crowd.step();
    const std::vector<glm::vec3> now = crowd.joints();
    for (std::size_t i = 0; i < before.size(); ++i) largest = std::max(largest, glm::distance(now[i], before[i]));
    before = now;
  }
  return largest;
}

TEST(Slot, ARequestThatInterruptsDoesNotSnap) {
  const float calm = largest_step(200, fade);
  ASSERT_GT(calm, 0.001F);
  for (const int frames_between : {1, 2, 5, 11, 23}) {
    EXPECT_LT(largest_step(frames_between, fade), 2.5F * calm) << "every " << frames_between << " frames";
  }
  EXPECT_GT(largest_step(5, Ticks{}), 2.5F * calm) << "else the promise above could not be broken";
}

TEST(Slot, LeavesNoEntityBehindWhoeverInterruptsWhom) {
  CrowdRig crowd = with_slot();
  crowd.step();
  for (int i = 0; i < 60; ++i) {
    play(crowd, {.clip = 1 + i % 4, .fade_in = i % 3 == 0 ? Ticks{} : fade, .fade_out = fade, .queued = i % 5 > 2});
    crowd.step(i % 9);
    EXPECT_LE(crowd.entities(), 16U);
  }
  crowd.step(1000);
  EXPECT_EQ(crowd.entities(), 1U);
  const EntityPools& pools = crowd->characters().pools(0);
  EXPECT_EQ(pools.pool(EntityPools::ease_blenders).alive_count(), 0U);
  EXPECT_EQ(pools.pool(EntityPools::inertialisers).alive_count(), 0U);
  EXPECT_EQ(pools.pool(EntityPools::sampled_players).alive_count(), 1U);
}

TEST(Slot, AllocatesNothingInAFrame) {
  CrowdRig crowd = with_slot();
  const PoseRequest update{.agent = {0}};
  const auto play_all = [&] {
    for (const int clip : {1, 2, 3}) {
      play(crowd, {.clip = clip, .fade_in = fade, .fade_out = fade, .queued = true});
    }
    const HotPathCounts before = hot_path_counts();
    while (channel(crowd).is_playing(crowd->clock())) {
      crowd->advance(frame_ticks);
      crowd->update({&update, 1});
    }
    return (hot_path_counts() - before).allocations;
  };
  play_all();
  EXPECT_EQ(play_all(), 0U);
}

TEST(Slot, ThatAStoreOfFixedSizeHasNoRoomForSaysSoAndIsStopped) {
  CrowdRig crowd({.local_store_bytes = 16 * 1024});
  crowd->agent(0).play({.clip = 0});
  ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<SlotChannel>()));
  const auto lay = [&] {
    return crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}), {.weight = 0.0F});
  };
  for (int layers = 0; lay(); ++layers) ASSERT_LT(layers, 32);
  const std::size_t before = crowd.entities();
  EXPECT_FALSE(play(crowd, {.clip = 1, .fade_in = fade}));
  ASSERT_TRUE(crowd->agent(0).change<SlotChannel>(slot, [](SlotChannel& own) { own.stop(); }));
  crowd.step(3);
  EXPECT_EQ(crowd.entities(), before);
}

TEST(Slot, OverNothingPlaysAlone) {
  CrowdRig crowd;
  const auto only = crowd->agent(0).add_channel(std::make_unique<SlotChannel>());
  ASSERT_TRUE(only);
  const auto ask = [](SlotChannel& own) { own.play({.clip = 1, .fade_in = fade, .fade_out = fade}); };
  ASSERT_TRUE(crowd->agent(0).change<SlotChannel>(*only, ask));
  crowd.step(5);
  EXPECT_EQ(crowd.entities(), 1U);
}

TEST(Slot, RefusesWhatHasNoEnd) {
  const HeardMisuses heard;
  CrowdRig crowd = with_slot();
  play(crowd, {.clip = 1, .speed = 0.0});
  play(crowd, {.clip = 99});
  play(crowd, {.clip = 1, .fade_in = -fade});
  EXPECT_EQ(heard.all().size(), 3U);
  EXPECT_FALSE(channel(crowd).took_all());
  crowd.step();
  EXPECT_EQ(crowd.entities(), 1U);
}

}  // namespace
}  // namespace throng::anim::slot_channel_test
