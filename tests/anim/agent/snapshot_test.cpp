// Whole-crowd snapshot, rewind and restore, with every kind of entity in play.

#include <gtest/gtest.h>

#include "engine/anim/agent/simple_channel.h"
#include "tests/anim/agent/every_kind.h"

namespace throng::anim::snapshot_test {
namespace {

constexpr int ten_seconds = 600;

void expect_the_same_again(const SystemOptions& options) {
  EveryKind crowd(options);
  crowd.step(ten_seconds);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  const std::uint64_t before = crowd->figures().pose_hash();
  crowd.step(ten_seconds);
  const std::uint64_t after = crowd->figures().pose_hash();
  EXPECT_NE(after, before);
  ASSERT_TRUE(crowd->restore(snapshot));
  EXPECT_EQ(crowd->figures().pose_hash(), before);
  crowd.step(ten_seconds);
  EXPECT_EQ(crowd->figures().pose_hash(), after);
}

TEST(Snapshot, RestoredGoesOnToTheSamePosesUnderFused) { expect_the_same_again({.pus = 2}); }

TEST(Snapshot, RestoredGoesOnToTheSamePosesUnderLevels) { expect_the_same_again({.schedule = Schedule::levels}); }

TEST(Snapshot, HasEveryKindOfEntityInPlay) {
  EveryKind crowd;
  crowd.step(100);
  const EntityPools& pools = crowd->characters().pools(0);
  std::size_t shared = 0;
  for (EntityPools::Kind kind = 0; kind < pools.kind_count(); ++kind) {
    shared += pools.shared_pool(kind).alive_count();
    if (kind == EntityPools::keyframe_players) continue;  // the other stream's
    EXPECT_GT(pools.pool(kind).alive_count(), 0U) << pools.layout(kind).kind->name;
  }
  EXPECT_EQ(shared, 3U);
}

TEST(Snapshot, MayBeRestoredAgainAndAgain) {
  EveryKind crowd;
  crowd.step(50);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  std::uint64_t hash = 0;
  for (int time = 0; time < 3; ++time) {
    ASSERT_TRUE(crowd->restore(snapshot));
    crowd.step(50);
    if (time == 0) hash = crowd->figures().pose_hash();
    EXPECT_EQ(crowd->figures().pose_hash(), hash);
  }
}

TEST(Snapshot, OfAnotherCrowdCountBringsItsAgentsBack) {
  EveryKind crowd;
  crowd.step(20);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(20);
  const std::uint64_t hash = crowd->figures().pose_hash();
  crowd->set_agent_count(3);
  ASSERT_TRUE(crowd->restore(snapshot));
  EXPECT_EQ(crowd->agent_count(), EveryKind::agents);
  crowd.step(20);
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
}

TEST(Snapshot, IsRefusedUnderAScheduleOfOtherBlocksAndNothingChanges) {
  EveryKind crowd;
  crowd.step(20);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  ASSERT_TRUE(crowd->configure({.schedule = Schedule::levels}));
  crowd.step(20);
  const std::uint64_t hash = crowd->figures().pose_hash();
  EXPECT_FALSE(crowd->restore(snapshot));
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
  crowd.step(20);
}

std::size_t players(const EveryKind& crowd, EntityPools::Kind stream) {
  return crowd->characters().pools(0).pool(stream).alive_count();
}

TEST(Snapshot, OfAnotherStreamPlaysTheStreamOfNow) {
  EveryKind crowd;
  crowd.step(20);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  const std::size_t sampled = players(crowd, EntityPools::sampled_players);
  ASSERT_TRUE(crowd->configure({.stream = StreamKind::keyframe}));
  const std::size_t kept = players(crowd, EntityPools::sampled_players);
  crowd.step(20);
  ASSERT_TRUE(crowd->restore(snapshot));
  EXPECT_EQ(players(crowd, EntityPools::sampled_players), kept) << "of clips without keyframes, or shared";
  EXPECT_EQ(players(crowd, EntityPools::keyframe_players), sampled - kept);
}

// A refusal goes back to the stream of before, which must be the one that everybody plays.
TEST(Snapshot, OfAnotherStreamIsPosedAsIfNothingHadBeenRefused) {
  const auto hash_after = [](bool refused) {
    EveryKind crowd;
    crowd.step(20);
    SystemSnapshot snapshot;
    crowd->snapshot(snapshot);
    EXPECT_TRUE(crowd->configure({.stream = StreamKind::keyframe}));
    EXPECT_TRUE(crowd->restore(snapshot));
    if (refused) {
      EXPECT_FALSE(crowd->configure({.local_store_bytes = 2048}));
    }
    crowd.step(20);
    return crowd->figures().pose_hash();
  };
  EXPECT_EQ(hash_after(true), hash_after(false));
}

/// Takes a snapshot of 30 layers, keeps one of them, and configures stores that have no room for the others.
void expect_that_there_is_no_room(const SystemOptions& options) {
  CrowdRig crowd({.local_store_bytes = 256 * 1024});
  crowd->agent(0).play({.clip = 0});
  for (int layer = 0; layer < 30; ++layer) {
    ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1})));
  }
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  while (crowd->agent(0).channel_count() > 1) crowd->agent(0).remove_channel(crowd->agent(0).channel_id(1));
  ASSERT_TRUE(crowd->configure(options));
  crowd.step();
  EXPECT_FALSE(crowd->restore(snapshot));
  EXPECT_EQ(crowd->agent(0).channel_count(), 1U);
  crowd.step();
}

TEST(Snapshot, IsRefusedWhereItsGraphsHaveNoRoom) { expect_that_there_is_no_room({.local_store_bytes = 16 * 1024}); }

TEST(Snapshot, OfAnotherStreamIsRefusedWhereThatStreamHasNoRoomAndNothingChanges) {
  expect_that_there_is_no_room({.local_store_bytes = 64 * 1024, .stream = StreamKind::keyframe});
}

TEST(Snapshot, ThatWasNeverTakenIsRefused) {
  CrowdRig crowd;
  const Status restored = crowd->restore(SystemSnapshot{});
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().message, "there is no crowd in this snapshot: take one first");
}

}  // namespace
}  // namespace throng::anim::snapshot_test
