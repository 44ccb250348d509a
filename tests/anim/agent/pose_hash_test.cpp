// One pose hash for each crowd, whatever the PUs, the schedule, the local store, the tile, the double buffering or the
// SIMD target; and the hash that it has always been. Targets without fused multiply-add have one of their own.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/every_kind.h"
#include "tests/anim/agent/fading_crowd.h"
#include "tests/anim/agent/hashed_crowds.h"

namespace throng::anim::pose_hash_test {
namespace {

constexpr std::size_t kib = 1024;
constexpr auto both_schedules = {Schedule::fused, Schedule::levels};

class PoseHash : public testing::TestWithParam<HashedCrowd> {
 protected:
  static std::uint64_t hash_of(const SystemOptions& options) { return GetParam().hash_of(options); }

  /// The hash on one PU under the options' defaults; computed once.
  static std::uint64_t reference(StreamKind stream = StreamKind::sampled) {
    static std::map<std::pair<std::string, StreamKind>, std::uint64_t> known;
    const auto [entry, is_new] = known.try_emplace({GetParam().name, stream});
    if (is_new) entry->second = hash_of({.stream = stream});
    return entry->second;
  }
};

TEST_P(PoseHash, IsTheSameForAnyNumberOfPus) {
  for (const int pus : {2, 3, 5, 16}) EXPECT_EQ(hash_of({.pus = pus}), reference()) << pus;
}

TEST_P(PoseHash, IsTheSameForBothSchedules) {
  for (const int pus : {1, 3}) EXPECT_EQ(hash_of({.pus = pus, .schedule = Schedule::levels}), reference()) << pus;
}

TEST_P(PoseHash, IsTheSameForAnyLocalStore) {
  for (const Schedule schedule : both_schedules) {
    for (const std::size_t size : GetParam().stores_kib) {
      EXPECT_EQ(hash_of({.local_store_bytes = size * kib, .schedule = schedule}), reference()) << size;
    }
  }
}

TEST_P(PoseHash, IsTheSameForAnyTile) {
  for (const Schedule schedule : both_schedules) {
    for (const int tile : {1, 2, 4, 8, 16}) {
      EXPECT_EQ(hash_of({.pus = 2, .local_store_bytes = 512 * kib, .tile = tile, .schedule = schedule}), reference())
          << tile;
    }
  }
}

TEST_P(PoseHash, IsTheSameForAnyDoubleBuffering) {
  for (const Schedule schedule : both_schedules) {
    for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
      EXPECT_EQ(hash_of({.pus = 2, .schedule = schedule, .double_buffering = mode}), reference());
    }
  }
}

TEST_P(PoseHash, IsTheSameForKeyframePlayersInAnyStore) {
  const std::uint64_t expected = reference(StreamKind::keyframe);
  EXPECT_NE(expected, reference()) << "the two streams differ";
  for (const std::size_t size : {std::size_t{0}, std::size_t{256}, std::size_t{1024}}) {
    for (const Schedule schedule : both_schedules) {
      const SystemOptions options{
          .pus = 2, .local_store_bytes = size * kib, .schedule = schedule, .stream = StreamKind::keyframe};
      EXPECT_EQ(hash_of(options), expected) << size;
    }
  }
}

// The other tests compare hashes with each other, so a change that moves every pose alike passes them. This one does
// not. Whoever means to change poses pins the new hash, and says in CHANGELOG.md what moved and why.
TEST_P(PoseHash, IsThePinnedOne) {
  for (const Kernels& kernels : runnable_kernels()) {
    const PinnedHashes& pinned = kernels.fused_multiply_add ? GetParam().fused : GetParam().apart;
    EXPECT_EQ(hash_of({.kernels = &kernels}), pinned.sampled) << kernels.target;
    EXPECT_EQ(hash_of({.stream = StreamKind::keyframe, .kernels = &kernels}), pinned.keyframe) << kernels.target;
  }
}

INSTANTIATE_TEST_SUITE_P(Crowds, PoseHash, testing::ValuesIn(hashed_crowds().begin(), hashed_crowds().end()),
                         [](const auto& tested) { return tested.param.name; });

TEST(PoseHashOfCrowds, DependsOnTheCrowd) { EXPECT_NE(hash_of_fading_crowd({}, 2), hash_of_fading_crowd({}, 1)); }

TEST(PoseHashOfCrowds, IsTheSameWhenTheScheduleChangesWhileRunning) {
  EveryKind crowd;
  for (int part = 0; part < 9; ++part) {
    const Schedule schedule = part % 2 == 0 ? Schedule::levels : Schedule::fused;
    ASSERT_TRUE(crowd->configure({.pus = 1 + part % 3, .schedule = schedule}));
    crowd.step(10);
  }
  EXPECT_EQ(crowd->figures().pose_hash(), hash_of_every_kind({}));
}

}  // namespace
}  // namespace throng::anim::pose_hash_test
