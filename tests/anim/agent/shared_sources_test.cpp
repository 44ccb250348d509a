// Sources that many agents read: updated once, fetched once a tile, never written back.

#include <array>
#include <cstring>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/run/fused/tasks.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::shared_sources_test {
namespace {

constexpr std::size_t kib = 1024;

/// Six shared players, and for each agent a tree of five blenders over them, one on top of the other.
struct DeepTrees {
  explicit DeepTrees(const SystemOptions& options, std::uint32_t agents = 16) : crowd(options, agents) {
    for (int clip = 0; clip < 6; ++clip) {
      const auto added = crowd->characters().add_shared(
          std::make_unique<SimpleChannel>(PlayerStart{.clip = clip % 5, .speed = 0.5 + 0.2 * clip}));
      EXPECT_TRUE(added) << added.error().message;
      shared.push_back(*added);
    }
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const Status added =
          crowd->agent(agent).add_channel(std::make_unique<FixedChannel>([&](const EntityBuilder& build) {
            std::vector<Handle> made;
            Handle below = shared[0];
            for (std::size_t depth = 1; depth <= 5; ++depth) {
              const float share = 0.1F * static_cast<float>((agent + depth) % 9);
              below = build.hold(below, shared[depth], share);
              made.push_back(below);
            }
            return made;
          }));
      EXPECT_TRUE(added) << added.error().message;
    }
  }
  CrowdRig crowd;
  std::vector<Handle> shared;
};

TEST(SharedSources, ATreeFiveDeepFetchesEachOnceATileAndWritesNoneBack) {
  DeepTrees trees({.local_store_bytes = 256 * kib});
  const AnimationSystem& system = *trees.crowd;
  const EntityPools& pools = system.characters().pools(0);
  ASSERT_EQ(trees.crowd.depth(), 6U) << "five blenders and a player";
  const Character& character = *test_character();
  const UpdateContext context{.hierarchy = &character.hierarchy,
                              .assets = {.clips = {},
                                         .masks = {},
                                         .selections = {},
                                         .kernels = &system.figures().kernels(),
                                         .bone_count = character.skeleton.bone_count(),
                                         .components = character.skeleton.components()},
                              .level_bone_counts = character.skeleton.level_bone_counts,
                              .pools = &pools};
  std::vector<AgentWork> work;
  for (std::uint32_t agent = 0; agent < 16; ++agent)
    work.push_back({.program = &system.agent(agent).program(),
                    .entities = system.agent(agent).graph().entities.data(),
                    .agent = agent});
  StoreNeeds needs;
  for (const AgentWork& agent : work) needs.widen(agent.program->needs);
  const std::vector<Tile> tiles{{.first = 0, .count = 4, .first_run = 0, .run_count = 1, .needs = needs},
                                {.first = 4, .count = 12, .first_run = 1, .run_count = 1, .needs = needs}};
  const std::vector<AgentRun> runs{{work.front().program, 0, 4}, {work.front().program, 0, 12}};
  TaskQueue queue(1);
  queue.open(std::array{0, static_cast<int>(tiles.size())});
  LocalStore store(256 * kib);
  store.divide(64 * kib, 2, 64 * kib);
  const AlignedBytes unseen = allocate_aligned(64 * kib);
  TileLists lists;
  lists.reserve(64 * kib);
  FusedTasks tasks({&context, 1}, work, {tiles, runs}, {queue, 0}, store, lists,
                   {.unseen = reinterpret_cast<PaletteMatrix*>(unseen.get())});
  CopyEngine engine;
  for (int tile = 0; tile < 2; ++tile) {
    tasks.fetch(tile, 0, engine);
    std::map<const std::byte*, int> fetches;
    for (const CopyEngine::Transfer& transfer : engine.queued()) fetches[transfer.from] += transfer.inward ? 1 : 0;
    for (const Handle source : trees.shared) EXPECT_EQ(fetches[pools.block(source)], 1);
    EXPECT_EQ(fetches.size(), trees.shared.size() + 5 * tiles[static_cast<std::size_t>(tile)].count);
    engine.finish();
    tasks.compute(tile, 0, engine);
    tasks.write_back(tile, 0, engine);
    for (const CopyEngine::Transfer& transfer : engine.queued()) EXPECT_FALSE(transfer.inward);
    const CopyCounts written = engine.finish();
    EXPECT_EQ(written.bytes_in, 0U);
    EXPECT_EQ(written.transfers, 5 * tiles[static_cast<std::size_t>(tile)].count) << "those of the agents alone";
  }
}

TEST(SharedSources, CostWhatTheirBlocksTakeOnceATile) {
  DeepTrees trees({.local_store_bytes = 256 * kib, .tile = 16, .double_buffering = DoubleBuffering::off});
  trees.crowd.step();
  const std::uint64_t block = 128 + pose_bytes(40, rigid_components);
  const CopyCounts counts = trees.crowd->figures().report().copies;
  EXPECT_EQ(counts.bytes_in, 6 * block + 16 * 5 * 64 + 6 * block) << "updated once, then read by one tile";
  EXPECT_EQ(counts.bytes_out, 6 * block + 16 * 5 * 64);
}

TEST(SharedSources, AreTheSameForAnyPusSchedulesAndTiles) {
  DeepTrees reference({});
  reference.crowd.step(60);
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const int pus : {1, 2, 3, 4}) {
      for (const int tile : {1, 4, 0}) {
        DeepTrees trees({.pus = pus, .tile = tile, .schedule = schedule});
        trees.crowd.step(60);
        EXPECT_EQ(trees.crowd->figures().pose_hash(), reference.crowd->figures().pose_hash())
            << pus << " PUs, tiles of " << tile;
      }
    }
  }
}

TEST(SharedSources, GiveTheBitsOfAPlayerOfTheAgentsOwn) {
  CrowdRig with;
  const Handle shared = *with->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = 2}));
  CrowdRig without;
  const auto half = [](Handle other) {
    return std::make_unique<FixedChannel>([other](const EntityBuilder& build) {
      const Handle one = build.player({.clip = 1});
      if (other.valid()) return std::vector{one, build.hold(one, other, 0.5F)};
      const Handle own = build.player({.clip = 2});
      return std::vector{one, own, build.hold(one, own, 0.5F)};
    });
  };
  ASSERT_TRUE(with->agent(0).add_channel(half(shared)));
  ASSERT_TRUE(without->agent(0).add_channel(half({})));
  with.step(100);
  without.step(100);
  EXPECT_EQ(with->figures().pose_hash(), without->figures().pose_hash());
}

TEST(SharedSources, MayBeAnAgentsWholePose) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    CrowdRig crowd({.schedule = schedule}, 3);
    const Handle shared = *crowd->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = 2}));
    struct Reading final : Channel {
      explicit Reading(Handle handle) : root(handle) {}
      Handle state() const override { return root; }
      bool update(const EntityBuilder&) override { return false; }
      void visit_handles(const std::function<void(Handle&)>&) override {}  // it is not ours
      void destroy_entities(const EntityBuilder&) override {}
      std::unique_ptr<Channel> clone() const override { return std::make_unique<Reading>(*this); }
      Handle root;
    };
    for (std::uint32_t agent = 0; agent < 3; ++agent) {
      ASSERT_TRUE(crowd->agent(agent).add_channel(std::make_unique<Reading>(shared)));
    }
    CrowdRig plain;
    plain->agent(0).play({.clip = 2});
    crowd.step(30);
    plain.step(30);
    for (std::uint32_t agent = 0; agent < 3; ++agent) {
      EXPECT_EQ(std::memcmp(crowd.palette(agent), plain.palette(), 40 * sizeof(PaletteMatrix)), 0);
    }
  }
}

TEST(SharedSources, MayReadEarlierOnes) {
  DeepTrees trees({.pus = 3});
  const Handle above = *trees.crowd->characters().add_shared(std::make_unique<FixedChannel>(
      [&](const EntityBuilder& build) { return std::vector{build.hold(trees.shared[0], trees.shared[1], 0.5F)}; }));
  EXPECT_EQ(trees.crowd->characters().pools(0).state(above).priority, highest_priority - 1);
  trees.crowd.step(10);
}

TEST(SharedSources, AreReadWithoutLookAhead) {
  DeepTrees ahead({});
  DeepTrees now({});
  for (int frame = 0; frame < 10; ++frame) {
    now.crowd.step();
    ahead.crowd->advance(frame_ticks);
    std::vector<PoseRequest> updates;
    for (std::uint32_t agent = 0; agent < 16; ++agent)
      updates.push_back({.agent = {agent}, .look_ahead = 5 * frame_ticks});
    ahead.crowd->update(updates);
  }
  EXPECT_EQ(ahead.crowd->figures().pose_hash(), now.crowd->figures().pose_hash());
}

TEST(SharedSources, GoOnWhereAFrameWithoutAgentsLeftThem) {
  DeepTrees every_frame({});
  DeepTrees pausing({});
  for (int frame = 0; frame < 10; ++frame) {
    every_frame.crowd->advance(frame_ticks);
    every_frame.crowd->update({});
  }
  pausing.crowd->advance(10 * frame_ticks);
  every_frame.crowd.step();
  pausing.crowd.step();
  EXPECT_TRUE(every_frame.crowd.bones_unlike(pausing.crowd).empty());
}

/// Sixteen agents, each with eight shared sources that no other reads.
std::uint64_t hash_of_sources_apart(int tile) {
  CrowdRig crowd({.local_store_bytes = 4096 * kib, .tile = tile}, 16);
  for (std::uint32_t agent = 0; agent < 16; ++agent) {
    std::vector<Handle> shared;
    for (int i = 0; i < 8; ++i) {
      shared.push_back(*crowd->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = i % 5})));
    }
    EXPECT_TRUE(crowd->agent(agent).add_channel(std::make_unique<FixedChannel>([shared](const EntityBuilder& build) {
      std::vector<Handle> made{shared[0]};
      for (std::size_t i = 1; i < shared.size(); ++i) {
        made.push_back(build.hold(made.back(), shared[i], 0.5F));
      }
      made.erase(made.begin());
      return made;
    })));
  }
  crowd.step(5);
  return crowd->figures().pose_hash();
}

TEST(SharedSources, MoreThanATileCanListAreSpreadOverSmallerTiles) {
  EXPECT_EQ(hash_of_sources_apart(16), hash_of_sources_apart(1));
}

TEST(SharedSources, ThatPlayNothingOrHaveACycleAreRefused) {
  CrowdRig crowd;
  const auto nothing = crowd->characters().add_shared(std::make_unique<CrossFadeChannel>());
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().message, "a shared channel must play something");
  const auto cycle = crowd->characters().add_shared(std::make_unique<FixedChannel>([](const EntityBuilder& build) {
    const Handle player = build.player({});
    const Handle blender = build.hold(player, player, 0.5F);
    build.as<EaseBlender>(blender).to = blender;
    return std::vector{player, blender};
  }));
  ASSERT_FALSE(cycle);
  EXPECT_THAT(cycle.error().message, testing::HasSubstr("among its own sources"));
  EXPECT_EQ(crowd->characters().pools(0).shared_pool(EntityPools::sampled_players).alive_count(), 0U);
}

}  // namespace
}  // namespace throng::anim::shared_sources_test
