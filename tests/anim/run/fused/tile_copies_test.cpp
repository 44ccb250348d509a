#include "engine/anim/run/fused/tile_copies.h"

#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/run/fused/tile_rig.h"

namespace throng::anim::tile_copies_test {
namespace {

/// Eight agents; a second clip fades in over the last three.
struct Walkers {
  Walkers() : crowd({}, 8) {
    for (std::uint32_t agent = 0; agent < 8; ++agent) {
      crowd->agent(agent).play({.clip = 0});
      if (agent >= 5) crowd->agent(agent).play({.clip = 1, .fade = ticks_per_second});
    }
    crowd.step();
  }
  std::byte* block(Handle entity) const { return const_cast<std::byte*>(crowd->agent(0).pools().block(entity)); }

  CrowdRig crowd;
};

TEST(TileCopies, BringEachBlockOfATileOnceRowByRow) {
  const Walkers walkers;
  TileRig rig(walkers.crowd);
  const TileInStore tile = rig.tile();
  ASSERT_EQ(tile.runs.size(), 2U);
  TileCopies copies(rig.lists, BlockChanges::written_back);
  copies.fetch(tile, 0, rig.engine);
  std::vector<const std::byte*> expected, fetched;
  for (const AgentRun& run : tile.runs) {
    for (std::size_t step = 0; step < run.program->steps.size(); ++step) {
      for (const AgentWork& work : tile.work.subspan(run.first, run.count))
        expected.push_back(walkers.block(work.entities[step]) + identity_bytes);
    }
  }
  for (const CopyEngine::Transfer& transfer : rig.engine.queued()) fetched.push_back(transfer.from);
  EXPECT_EQ(fetched, expected);
  rig.engine.finish();
}

TEST(TileCopies, WriteEachBlockBackWhereItCameFrom) {
  const Walkers walkers;
  TileRig rig(walkers.crowd);
  const TileInStore tile = rig.tile();
  TileCopies copies(rig.lists, BlockChanges::written_back);
  copies.fetch(tile, 0, rig.engine);
  rig.engine.finish();
  const auto for_each_step = [&](auto&& visit) {
    int number = 0;
    for (const AgentWork& work : tile.work) {
      for (std::size_t step = 0; step < work.program->steps.size(); ++step)
        visit(++number, work.entities[step], work.program->steps[step].layout(walkers.crowd->agent(0).pools()));
    }
  };
  std::byte* block = tile.blocks;
  for_each_step([&](int number, Handle, const EntityLayout& layout) {
    std::memset(block + identity_bytes, number, layout.total_size - identity_bytes);
    block += layout.total_size;
  });
  copies.write_back_final(tile, 0, rig.engine);
  copies.write_back(tile, 0, rig.engine);
  rig.engine.finish();
  for_each_step([&](int number, Handle entity, const EntityLayout&) {
    EXPECT_EQ(std::to_integer<int>(walkers.block(entity)[identity_bytes]), number);
  });
}

TEST(TileCopies, WriteNothingBackOfALookAtWhatWouldBe) {
  const Walkers walkers;
  TileRig rig(walkers.crowd);
  const TileInStore tile = rig.tile();
  TileCopies copies(rig.lists, BlockChanges::dropped);
  copies.fetch(tile, 0, rig.engine);
  EXPECT_GT(rig.engine.finish().bytes_in, 0U);
  copies.write_back_final(tile, 0, rig.engine);
  copies.write_back(tile, 0, rig.engine);
  EXPECT_EQ(rig.engine.finish().bytes_out, 0U);
}

TEST(TileLists, AreAsLongAsABufferCanHoldBlocks) {
  const CrowdRig crowd;
  const ScheduleOptions& schedule = crowd->figures().schedule();
  TileLists lists;
  lists.reserve(schedule.plan.fetch_bytes);
  for (const std::vector<std::byte*>& list : lists.origins)
    EXPECT_EQ(list.size(), schedule.plan.fetch_bytes / entity_header_bytes);
  EXPECT_EQ(crowd->figures().units().front().list_bytes(), lists.bytes());
  EXPECT_LT(lists.bytes(), schedule.local_store_bytes / 4) << "they were twice the store";
}

}  // namespace
}  // namespace throng::anim::tile_copies_test
