#include "engine/anim/run/tile_cutter.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::tile_cutter_test {
namespace {

const CostModel cost;

double of_shares(std::span<const Tile> tiles, std::span<const int> shares, std::size_t share) {
  double sum = 0;
  for (int tile = shares[share]; tile < shares[share + 1]; ++tile) {
    sum += static_cast<double>(tiles[static_cast<std::size_t>(tile)].cost);
  }
  return sum;
}

/// What a scheduler sees of a crowd of a character of 40 bones.
class Crowd {
 public:
  explicit Crowd(std::uint32_t agents) : rig_({}, agents), packets_(context_packets()) {
    for (std::uint32_t agent = 0; agent < agents; ++agent) add(agent, 0, {1, 0, 0});
  }

  void add(std::uint32_t agent, int level, const ProgramParts& parts) {
    work.push_back({.program = &rig_->agent(agent % rig_->agent_count()).program(),
                    .agent = agent,
                    .cost = cost_in_steps(cost.of_agent(parts, packets_)),
                    .level = static_cast<std::uint8_t>(level & 3)});
  }

  std::vector<Tile> cut(std::span<int> shares) {
    find_runs(work, runs_);
    order_.sort({work, runs_});
    TileCutter cutter;
    cutter.reserve(work.size());
    const CutWork cut = cutter.cut(contexts(), order_, rig_->figures().schedule().plan, Schedule::fused, cost, shares);
    runs_of_tiles.assign(cut.runs.begin(), cut.runs.end());
    return {cut.tiles.begin(), cut.tiles.end()};
  }

  std::vector<AgentWork> work;
  std::vector<AgentRun> runs_of_tiles;  ///< of the last cut
  const WorkOrder& order() const { return order_; }
  const LocalStorePlan& plan() const { return rig_->figures().schedule().plan; }

 private:
  std::span<const UpdateContext> contexts() {
    context_ = {.hierarchy = &rig_->characters()[0].hierarchy,
                .assets = {.bone_count = rig_->characters()[0].skeleton.bone_count()},
                .level_bone_counts = rig_->characters()[0].skeleton.level_bone_counts,
                .pools = &rig_->characters().pools(0)};
    return {&context_, 1};
  }
  int context_packets() { return contexts().front().packets(0); }

  CrowdRig rig_;
  std::vector<WorkRun> runs_;
  WorkOrder order_;
  UpdateContext context_;
  int packets_;
};

TEST(CostModel, GrowsWithBonesSourcesAndPostProcesses) {
  const ProgramParts clip{1, 0, 0}, fade{2, 1, 0}, gazing{1, 0, 1};
  EXPECT_GT(cost.of_agent(clip, 4), cost.of_agent(clip, 1));
  EXPECT_GT(cost.of_agent(fade, 4), cost.of_agent(clip, 4));
  EXPECT_GT(cost.of_agent(gazing, 4), cost.of_agent(clip, 4));
}

TEST(CostModel, CountsThePartsOfAProgram) {
  CrowdRig crowd({}, 1);
  crowd->agent(0).play({.clip = 0});
  crowd->agent(0).play({.clip = 1, .fade = ticks_per_second});
  const ProgramParts& parts = crowd->agent(0).program().parts;
  EXPECT_EQ(parts.players, 2);
  EXPECT_EQ(parts.blenders, 1);
  EXPECT_EQ(parts.whole_pose_work, 0);
}

TEST(CutShares, AreOfAboutEqualCostWhateverTheTasksAre) {
  std::mt19937 random(1);
  std::vector<int> costs(200);
  for (int& one : costs) one = 1 + static_cast<int>(random() % 50);
  std::array<int, 6> firsts{};
  cut_shares(
      200, [&](int task) { return costs[static_cast<std::size_t>(task)]; }, firsts);
  EXPECT_EQ(firsts.front(), 0);
  EXPECT_EQ(firsts.back(), 200);
  double total = 0;
  for (const int one : costs) total += one;
  for (std::size_t share = 0; share + 1 < firsts.size(); ++share) {
    double sum = 0;
    for (int task = firsts[share]; task < firsts[share + 1]; ++task) sum += costs[static_cast<std::size_t>(task)];
    EXPECT_NEAR(sum, total / 5, 50);
  }
}

TEST(CutShares, HaveEachTaskOnceWhereThereAreFewerTasksThanShares) {
  std::array<int, 9> firsts{};
  cut_shares(
      2, [](int) { return 1; }, firsts);
  EXPECT_TRUE(std::ranges::is_sorted(firsts));
  EXPECT_EQ(firsts.front(), 0);
  EXPECT_EQ(firsts.back(), 2);
}

TEST(TileCutter, LosesNobody) {
  Crowd crowd(1000);
  std::array<int, 4> shares{};
  std::uint32_t next = 0;
  for (const Tile& tile : crowd.cut(shares)) {
    EXPECT_EQ(tile.first, next);
    EXPECT_GT(tile.count, 0U);
    next += tile.count;
  }
  EXPECT_EQ(next, 1000U);
}

TEST(TileCutter, GivesEachTileItsRunsOfAgentsWhoRunOneProgram) {
  for (const std::size_t pus : {1U, 2U, 5U}) {
    for (const std::size_t walking : {16U, 20U, 32U, 95U}) {
      Crowd crowd(96);
      const PoseProgram other = *crowd.work.front().program;
      for (std::size_t i = walking; i < crowd.work.size(); ++i) crowd.work[i].program = &other;
      for (std::size_t i = 0; i < crowd.work.size(); i += 3)
        ++crowd.work[i].cost;  // which does not end a run of a tile
      std::vector<int> shares(pus + 1);
      const std::vector<Tile> tiles = crowd.cut(shares);
      const CutWork cut{tiles, crowd.runs_of_tiles};
      std::size_t runs = 0;
      for (const Tile& tile : tiles) {
        const std::span<const AgentWork> agents = crowd.order().work().subspan(tile.first, tile.count);
        std::uint32_t next = 0;
        const PoseProgram* before = nullptr;
        for (const AgentRun& run : cut.runs_of(tile)) {
          EXPECT_EQ(run.first, next);
          EXPECT_NE(run.program, before) << "a longer run was there";
          for (const AgentWork& work : agents.subspan(run.first, run.count)) EXPECT_EQ(work.program, run.program);
          next = run.end();
          before = run.program;
          ++runs;
        }
        EXPECT_EQ(next, tile.count);
      }
      EXPECT_EQ(runs, cut.runs.size());
    }
  }
}

TEST(AgentRun, OfPartOfATileIsCountedFromItsFirstAgent) {
  const PoseProgram walking, turning;
  const std::vector<AgentRun> runs{{&walking, 0, 10}, {&turning, 10, 12}, {&walking, 22, 10}};
  std::vector<std::array<std::uint32_t, 2>> seen;
  for_each_run(runs, 16, 16, [&](const AgentRun& run) { seen.push_back({run.first, run.count}); });
  EXPECT_THAT(seen, testing::ElementsAre(std::array{0U, 6U}, std::array{6U, 10U}));
}

TEST(TileCutter, PredictsOfATileWhatItsAgentsAndThePacketsOfItsStripsTake) {
  Crowd crowd(40);
  std::array<int, 2> shares{};
  for (const Tile& tile : crowd.cut(shares)) {
    double agents = 0;
    for (const AgentWork& work : crowd.order().work().subspan(tile.first, tile.count)) agents += work.cost * cost_step;
    EXPECT_NEAR(static_cast<double>(tile.cost), tile.strips() * cost.of_tile(3) + agents, 0.01);
  }
}

TEST(TileCutter, PutsTwoStripsIntoATileWhereTheStoreHoldsTheirCharacters) {
  Crowd crowd(80);
  PoseProgram large = *crowd.work.front().program;
  large.needs.fetch_bytes = static_cast<std::uint32_t>(crowd.plan().fetch_bytes) / 24;
  for (std::size_t i = 48; i < crowd.work.size(); ++i) crowd.work[i].program = &large;
  std::array<int, 2> shares{};
  std::vector<std::uint32_t> counts;
  for (const Tile& tile : crowd.cut(shares)) {
    EXPECT_EQ(tile.width, 16U);
    counts.push_back(tile.count);
  }
  EXPECT_THAT(counts, testing::ElementsAre(32, 16, 16, 16));
}

TEST(TileCutter, NarrowsTheTileOfWhoeverNeedsMuchRoomAndNoneBehindIt) {
  Crowd crowd(66);
  PoseProgram large = *crowd.work.front().program;
  large.needs.fetch_bytes = static_cast<std::uint32_t>(crowd.plan().fetch_bytes) / 3;
  crowd.work.front().program = &large;
  std::array<int, 2> shares{};
  std::vector<std::uint32_t> widths, counts;
  for (const Tile& tile : crowd.cut(shares)) {
    widths.push_back(tile.width);
    counts.push_back(tile.count);
  }
  EXPECT_THAT(widths, testing::ElementsAre(2, 16, 16));
  EXPECT_THAT(counts, testing::ElementsAre(2, 32, 32)) << "who comes next joins it as long as there is room";
}

TEST(TileCutter, CutsBetweenStripsBeforeItCutsAStrip) {
  Crowd crowd(96);
  std::array<int, 3> shares{};
  std::vector<std::uint32_t> counts;
  for (const Tile& tile : crowd.cut(shares)) counts.push_back(tile.count);
  EXPECT_THAT(counts, testing::ElementsAre(32, 16, 16, 32));
  EXPECT_EQ(shares, (std::array{0, 2, 4}));
}

TEST(TileCutter, CutsAWideTileSoThatNoPuIsLate) {
  for (const std::uint32_t agents : {17U, 24U, 40U, 56U, 100U}) {
    Crowd crowd(agents);
    std::array<int, 3> shares{};
    const std::vector<Tile> tiles = crowd.cut(shares);
    const double first = of_shares(tiles, shares, 0), second = of_shares(tiles, shares, 1);
    EXPECT_NEAR(first, second, 2 * (cost.of_tile(3) + cost.of_agent({1, 0, 0}, 3))) << agents;
  }
}

TEST(TileCutter, LeavesTilesWholeWhereCuttingCostsMoreThanItGains) {
  Crowd crowd(2);
  std::array<int, 3> shares{};
  EXPECT_EQ(crowd.cut(shares).size(), 1U);
}

TEST(PusWorthWaking, AreFewForLittleWork) {
  EXPECT_EQ(pus_worth_waking(0, 8, cost), 1);
  EXPECT_EQ(pus_worth_waking(3 * cost.least_task, 8, cost), 3);
  EXPECT_EQ(pus_worth_waking(1e12, 8, cost), 8);
}

}  // namespace
}  // namespace throng::anim::tile_cutter_test
