// No allocation and no lock on the hot path.

#include <memory>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::anim::hot_path_test {
namespace {

constexpr std::uint32_t agents = 200;
constexpr int warm_up_frames = 5;
constexpr int counted_frames = 120;

TEST(HotPathCounter, SeesAllocationsAndLocks) {
  std::mutex mutex;
  const HotPathCounts before = hot_path_counts();
  {
    const std::lock_guard lock(mutex);
    const auto memory = std::make_unique<std::vector<int>>(3);
    EXPECT_EQ(memory->size(), 3U);
  }
  const HotPathCounts counts = hot_path_counts() - before;
  EXPECT_EQ(counts.allocations, 2U);
#ifndef __SANITIZE_THREAD__
  EXPECT_EQ(counts.locks, 1U);
#endif
}

/// Agents that have one clip, a fade that ends on the way, or two clips that stay, updated at every level and interval.
HotPathCounts counts_of_frames(const SystemOptions& options) {
  CrowdRig crowd(options, agents);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    crowd->agent(agent).play({.clip = 0});
    if (agent % 3 == 1) crowd->agent(agent).play({.clip = 1, .fade = ticks_per_second});
    if (agent % 3 == 2) crowd->agent(agent).play({.clip = 2, .held_fraction = 0.5F});
  }
  const std::size_t levels = crowd->characters()[0].skeleton.level_bone_counts.size();
  HotPathCounts before;
  updates.reserve(agents);
  for (int frame = 0; frame < warm_up_frames + counted_frames; ++frame) {
    if (frame == warm_up_frames) before = hot_path_counts();
    updates.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const std::uint32_t interval = 1 + agent % 4;
      if (static_cast<std::uint32_t>(frame) % interval != 0) continue;
      updates.push_back(
          {.agent = agent, .level = static_cast<std::uint8_t>(agent % levels), .look_ahead = interval * frame_ticks});
    }
    crowd->advance(frame_ticks);
    crowd->update(updates);
  }
  return hot_path_counts() - before;
}

TEST(HotPath, NeitherAllocatesNorLocksUnderAnySchedule) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int pus : {1, 3}) {
      for (const StreamKind stream : {StreamKind::sampled, StreamKind::keyframe}) {
        const HotPathCounts counts = counts_of_frames({.pus = pus, .schedule = schedule, .stream = stream});
        EXPECT_EQ(counts.allocations, 0U) << "schedule " << static_cast<int>(schedule) << ", PUs " << pus;
        EXPECT_EQ(counts.locks, 0U) << "schedule " << static_cast<int>(schedule) << ", PUs " << pus;
      }
    }
  }
}

TEST(BytesPerAgent, OfTwoPlayersAndABlenderAreAtMostAKibibyte) {
  CrowdRig crowd({.schedule = Schedule::fused}, agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    crowd->agent(agent).play({.clip = 0});
    crowd->agent(agent).play({.clip = 1, .held_fraction = 0.5F});
  }
  EXPECT_EQ(crowd.entities(), 3U);
  EXPECT_LE(crowd->figures().bytes_per_agent(), 1024.0);
  EXPECT_GE(crowd->figures().bytes_per_agent(), 3.0 * 128) << "three transient blocks are in it";
}

}  // namespace
}  // namespace throng::anim::hot_path_test
