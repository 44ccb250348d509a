// One pose hash with every kind of entity in play, whatever the PUs, the schedule, the local store, the tile or the
// double buffering.

#include <gtest/gtest.h>

#include "tests/anim/agent/every_kind.h"

namespace throng::anim {
namespace {

constexpr int frames = 90;
constexpr std::size_t kib = 1024;

std::uint64_t hash_of(const SystemOptions& options) {
  EveryKind crowd(options);
  crowd.step(frames);
  return crowd->pose_hash();
}

std::uint64_t reference(StreamKind stream) {
  static const std::uint64_t sampled = hash_of({});
  static const std::uint64_t keyframe = hash_of({.stream = StreamKind::keyframe});
  return stream == StreamKind::sampled ? sampled : keyframe;
}

TEST(EveryKindHash, IsTheSameForAnyPusUnderBothSchedules) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int pus : {1, 2, 3}) {
      EXPECT_EQ(hash_of({.pus = pus, .schedule = schedule}), reference(StreamKind::sampled)) << pus;
    }
  }
}

TEST(EveryKindHash, IsTheSameForAnyLocalStore) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const std::size_t size : {std::size_t{40}, std::size_t{64}, std::size_t{200}, std::size_t{1024}}) {
      EXPECT_EQ(hash_of({.local_store_bytes = size * kib, .schedule = schedule}), reference(StreamKind::sampled))
          << size;
    }
  }
}

TEST(EveryKindHash, IsTheSameForAnyTile) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int tile : {0, 1, 2, 4, 8, 16}) {
      EXPECT_EQ(hash_of({.pus = 2, .local_store_bytes = 512 * kib, .tile = tile, .schedule = schedule}),
                reference(StreamKind::sampled))
          << tile;
    }
  }
}

TEST(EveryKindHash, IsTheSameForAnyDoubleBuffering) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
      EXPECT_EQ(hash_of({.pus = 2, .schedule = schedule, .double_buffering = mode}), reference(StreamKind::sampled));
    }
  }
}

TEST(EveryKindHash, IsTheSameForKeyframePlayers) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    EXPECT_EQ(hash_of({.pus = 3, .schedule = schedule, .stream = StreamKind::keyframe}),
              reference(StreamKind::keyframe));
  }
  EXPECT_NE(reference(StreamKind::keyframe), reference(StreamKind::sampled));
}

TEST(EveryKindHash, IsTheSameWhenTheScheduleChangesWhileRunning) {
  EveryKind crowd;
  for (int part = 0; part < 9; ++part) {
    const Schedule schedule = part % 2 == 0 ? Schedule::levels : Schedule::fused;
    ASSERT_TRUE(crowd->configure({.pus = 1 + part % 3, .schedule = schedule}));
    crowd.step(frames / 9);
  }
  EXPECT_EQ(crowd->pose_hash(), reference(StreamKind::sampled));
}

}  // namespace
}  // namespace throng::anim
