// What a system tells about its updates in numbers.

#include <algorithm>
#include <numeric>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::figures_test {
namespace {

constexpr std::uint32_t agents = 5;

CrowdRig crowd_that_plays(const SystemOptions& options = {}) {
  CrowdRig crowd(options, agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) crowd->agent(agent).play({.clip = 0});
  return crowd;
}

TEST(Figures, ReportTheLastUpdate) {
  CrowdRig crowd = crowd_that_plays();
  crowd.step(3);
  const Figures figures = crowd->figures();
  const auto bones = static_cast<std::uint64_t>(test_character()->skeleton.bone_count());
  EXPECT_EQ(figures.report().agents_updated, agents);
  EXPECT_EQ(figures.report().bones_evaluated, agents * bones);
  EXPECT_GT(figures.report().predicted_nanoseconds, 0.0);
  crowd->update({});
  EXPECT_EQ(figures.report().agents_updated, 0U) << "they follow the system";
}

TEST(Figures, HaveAHashOfEachAgent) {
  CrowdRig crowd = crowd_that_plays();
  EXPECT_EQ(crowd->figures().pose_hash(), 0U);
  crowd.step();
  const std::span<const std::uint64_t> hashes = crowd->figures().agent_hashes();
  ASSERT_EQ(hashes.size(), agents);
  EXPECT_NE(hashes[0], hashes[1]) << "it is seeded by the agent";
  EXPECT_NE(crowd->figures().pose_hash(), 0U);
}

TEST(Figures, HashNothingUnlessAsked) {
  CrowdRig crowd = crowd_that_plays({.hash = false});
  crowd.step();
  EXPECT_EQ(crowd->figures().pose_hash(), 0U);
}

TEST(Figures, TellHowTheSystemRuns) {
  const CrowdRig crowd = crowd_that_plays({.pus = 2, .tile = 4});
  EXPECT_EQ(crowd->figures().units().size(), 2U);
  EXPECT_EQ(crowd->figures().schedule().pus, 2);
  EXPECT_EQ(crowd->figures().schedule().plan.width, 4);
  EXPECT_EQ(crowd->figures().kernels().target, best_kernels().target);
}

TEST(Figures, CountTheMemoryOfEveryKind) {
  const CrowdRig crowd = crowd_that_plays();
  const std::vector<KindMemory> kinds = crowd->figures().memory();
  const std::size_t blocks = std::accumulate(
      kinds.begin(), kinds.end(), std::size_t{0},
      [](std::size_t sum, auto& kind) { return sum + kind.own.blocks_alive + kind.shared.blocks_alive; });
  EXPECT_EQ(blocks, agents) << "a player for each";
  EXPECT_GT(crowd->figures().bytes_per_agent(), 64.0);
}

TEST(Figures, CountTheStreamsThatPlayersRead) {
  CrowdRig crowd = crowd_that_plays();
  crowd.step();
  const std::uint64_t all = crowd->figures().stream_bytes();
  const PoseRequest one{.agent = {0}};
  crowd->update({&one, 1});
  EXPECT_EQ(all, agents * crowd->figures().stream_bytes());
}

}  // namespace
}  // namespace throng::anim::figures_test
