// One pose hash whatever the PUs, the schedule, the local store, the tile or the double buffering.

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {
namespace {

constexpr std::uint32_t agents = 200;
constexpr int frames = 20;
constexpr std::size_t kib = 1024;

std::shared_ptr<const Character> character() {
  static const auto shared = std::make_shared<const Character>(bake_character(synthetic_model(62, 3)));
  return shared;
}

PlayRequest request(std::uint32_t agent, std::uint32_t turn, unsigned seed) {
  const std::uint32_t mixed = (agent + seed * 31U) * 2654435761U + turn * 40503U;
  return {.clip = static_cast<int>(mixed % 3),
          .fade = turn == 0 ? 0 : to_ticks(0.15 + 0.01 * (mixed % 7)),
          .speed = 0.8 + 0.05 * (mixed % 9),
          .start = to_ticks(0.001 * (mixed % 800))};
}

/// Runs a crowd whose agents start fades at different times and skip some updates; returns the hash after the last
/// frame.
std::uint64_t run_crowd(const SystemOptions& options, unsigned seed = 1) {
  auto created = AnimationSystem::create(character(), options);
  EXPECT_TRUE(created.has_value()) << (created ? "" : created.error().message);
  if (!created) return 0;
  AnimationSystem& system = **created;
  system.set_agent_count(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) system.play(agent, request(agent, 0, seed));
  std::vector<AgentUpdate> updates;
  for (std::uint32_t frame = 1; frame <= frames; ++frame) {
    system.advance(ticks_per_second / 60);
    updates.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      if ((agent + frame) % 11 == 0) system.play(agent, request(agent, frame, seed));
      if (agent % 3 == 0 && frame % 2 == 0) continue;
      const auto levels = static_cast<std::uint32_t>(character()->skeleton.level_bone_counts.size());
      updates.push_back({.agent = agent,
                         .level = static_cast<std::uint8_t>(agent / 7 % levels),
                         .look_ahead = agent % 3 == 0 ? ticks_per_second / 30 : 0});
    }
    system.update(updates);
  }
  return system.pose_hash();
}

std::uint64_t reference(StreamKind stream) {
  static const std::uint64_t sampled = run_crowd({});
  static const std::uint64_t keyframe = run_crowd({.stream = StreamKind::keyframe});
  return stream == StreamKind::sampled ? sampled : keyframe;
}

TEST(PoseHash, IsTheSameForAnyNumberOfPus) {
  for (const int pus : {2, 3, 5, 7, 16}) EXPECT_EQ(run_crowd({.pus = pus}), reference(StreamKind::sampled)) << pus;
}

TEST(PoseHash, IsTheSameForBothSchedules) {
  for (const int pus : {1, 3}) {
    EXPECT_EQ(run_crowd({.pus = pus, .schedule = Schedule::levels}), reference(StreamKind::sampled)) << pus;
  }
}

TEST(PoseHash, IsTheSameForAnyLocalStore) {
  for (const std::size_t size :
       {std::size_t{16}, std::size_t{32}, std::size_t{128}, std::size_t{256}, std::size_t{512}, std::size_t{1024}}) {
    for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
      EXPECT_EQ(run_crowd({.local_store_bytes = size * kib, .schedule = schedule}), reference(StreamKind::sampled))
          << size;
    }
  }
}

TEST(PoseHash, IsTheSameForAnyTile) {
  for (const int tile : {0, 1, 2, 4, 8, 16}) {
    for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
      EXPECT_EQ(run_crowd({.pus = 2, .tile = tile, .schedule = schedule}), reference(StreamKind::sampled)) << tile;
    }
  }
}

TEST(PoseHash, IsTheSameForAnyDoubleBuffering) {
  for (const auto mode : {DoubleBuffering::off, DoubleBuffering::inline_copy, DoubleBuffering::interleaved}) {
    for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
      EXPECT_EQ(run_crowd({.pus = 2, .schedule = schedule, .double_buffering = mode}), reference(StreamKind::sampled));
    }
  }
}

TEST(PoseHash, IsTheSameForKeyframePlayersInAnyStore) {
  for (const std::size_t size : {std::size_t{64}, std::size_t{256}, std::size_t{1024}}) {
    EXPECT_EQ(run_crowd({.pus = 2, .local_store_bytes = size * kib, .stream = StreamKind::keyframe}),
              reference(StreamKind::keyframe));
  }
  for (const std::size_t size : {std::size_t{16}, std::size_t{64}, std::size_t{1024}}) {
    EXPECT_EQ(
        run_crowd({.local_store_bytes = size * kib, .schedule = Schedule::levels, .stream = StreamKind::keyframe}),
        reference(StreamKind::keyframe));
  }
}

TEST(PoseHash, DependsOnTheCrowd) {
  EXPECT_NE(run_crowd({}, 2), reference(StreamKind::sampled));
  EXPECT_NE(reference(StreamKind::keyframe), reference(StreamKind::sampled));
}

TEST(PoseHash, IsTheSameOnEveryTargetWithFusedMultiplyAdd) {
  for (const Kernels& kernels : runnable_kernels()) {
    if (!kernels.fused_multiply_add) continue;
    EXPECT_EQ(run_crowd({.kernels = &kernels}), reference(StreamKind::sampled)) << kernels.target;
  }
}

}  // namespace
}  // namespace throng::anim
