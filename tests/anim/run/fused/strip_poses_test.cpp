#include "engine/anim/run/fused/strip_poses.h"

#include <gtest/gtest.h>

#include "engine/anim/agent/noise_process.h"
#include "engine/anim/run/fused/advance.h"
#include "engine/anim/run/fused/tile_copies.h"
#include "tests/anim/run/fused/tile_rig.h"

namespace throng::anim::strip_poses_test {
namespace {

/// Eight agents who walk; those from `first_noisy` on have noise over it, the last one twice. They are advanced.
struct Walkers {
  explicit Walkers(std::uint32_t first_noisy) : crowd(noisy(first_noisy)), rig(crowd), tile(rig.tile()) {
    TileCopies(rig.lists, BlockChanges::dropped).fetch(tile, 0, rig.engine);
    rig.engine.finish();
    cursor = rig.first_step();
    advance_entities(tile, cursor, rig.lists);
  }
  Strip find(std::size_t first) {
    const Strip strip = rig.strip(tile, first);
    poses.find(strip, rig.lists, cursor);
    return strip;
  }

  static CrowdRig noisy(std::uint32_t first_noisy) {
    CrowdRig crowd({}, 8);
    for (std::uint32_t agent = 0; agent < 8; ++agent) {
      crowd->agent(agent).play({.clip = 0});
      const int times = agent < first_noisy ? 0 : agent == 7 ? 2 : 1;
      for (int i = 0; i < times; ++i)
        EXPECT_TRUE(crowd->agent(agent).add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{})));
    }
    crowd.step();
    return crowd;
  }

  CrowdRig crowd;
  TileRig rig;
  TileInStore tile;
  StepCursor cursor;
  StripPoses poses;
};

TEST(StripPoses, OfCharactersWhoPlayClipsAreClipsAlone) {
  Walkers walkers(8);
  for (const std::size_t first : {0U, 4U}) {
    walkers.find(first);
    EXPECT_FALSE(walkers.poses.any_composed());
    EXPECT_EQ(walkers.poses.tails().count(), 0U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NE(walkers.poses.clips().of(i).clip, nullptr);
  }
  EXPECT_EQ(walkers.cursor.block, walkers.tile.blocks + walkers.tile.own_bytes()) << "it is left behind the last block";
}

TEST(StripPoses, PutTheLastStepsOfManyCharactersIntoOneRound) {
  Walkers walkers(2);
  const TailRounds& tails = walkers.rig.lists.tails;
  const Strip left = walkers.find(0);
  EXPECT_TRUE(walkers.poses.any_composed());
  EXPECT_FALSE(walkers.poses.any_heads()) << "noise is a tail over clips";
  ASSERT_EQ(tails.count(), 1U);
  ASSERT_EQ(tails.entities(0).size(), 2U);
  EXPECT_EQ(tails.entities(0)[0].pose, left.pose(2));
  EXPECT_EQ(tails.entities(0)[1].pose, left.pose(3));
  const Strip right = walkers.find(4);
  ASSERT_EQ(tails.count(), 2U);
  EXPECT_EQ(tails.entities(0).size(), 4U);
  ASSERT_EQ(tails.entities(1).size(), 1U) << "one character has noise twice";
  EXPECT_EQ(tails.entities(1)[0].pose, right.pose(3));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NE(walkers.poses.clips().of(i).clip, nullptr) << "a composed pose begins with the clip below its noise";
  }
}

}  // namespace
}  // namespace throng::anim::strip_poses_test
