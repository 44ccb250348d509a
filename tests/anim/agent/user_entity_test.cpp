// A low-level entity of your own kind (paper 2.2.6: "we can derive various animation tasks that can result in animation
// states"), used as a source by a blender as players are.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/entity_run.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::user_entity_test {
namespace {

// 1. The block. It is copied, moved and written to disk as bytes: no pointers, nothing that owns.
struct alignas(64) Sway {
  AnimationStateHeader state;
  Ticks time;
  float period;   ///< seconds
  float radians;  ///< to either side
};
static_assert(sizeof(Sway) == entity_header_bytes && std::is_trivially_copyable_v<Sway>);

/// A private part lies behind header and transforms: here, how far each bone follows.
std::size_t share_bytes(int bone_count, int) {
  return static_cast<std::size_t>(packets_for(bone_count)) * packet_bones * sizeof(float);
}

/// What advance() hands on to the packets, in the local store too.
struct Turn {
  float radians;
};

// 2. The update, once a frame: use up the time.
void advance_sway(const EntityInStore& entity, const SourcesInStore&) {
  auto& sway = entity.as<Sway>();
  sway.time += sway.state.delta_time;
  sway.state.delta_time = Ticks{};
  const double cycles = to_seconds(sway.time) / static_cast<double>(sway.period);
  const double turn = std::sin(2.0 * std::numbers::pi * (cycles - std::floor(cycles)));
  entity.prepared_as<Turn>().radians = sway.radians * static_cast<float>(turn);
}

// 3. The pose, 16 bones at a time.
void sway_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto* const shares = reinterpret_cast<const float*>(entity.private_part().data());
  std::fill_n(job.out, entity.assets->components * packet_bones, 0.0F);
  for (int bone = 0; bone < packet_bones; ++bone) {
    const float half = 0.5F * entity.prepared_as<Turn>().radians * shares[job.packet * packet_bones + bone];
    job.out[2 * packet_bones + bone] = std::sin(half);
    job.out[3 * packet_bones + bone] = std::cos(half);
  }
}

// 4. The kind. Bytes that advance() prepares for the packets are asked for here.
const EntityKind sway_kind = {.name = "sway",
                              .private_bytes_for = share_bytes,
                              .prepared_bytes = 64,
                              .advance = advance_each<advance_sway>,
                              .pose_packet = sway_packet};

Handle make_sway(const EntityBuilder& build, EntityPools::Kind kind) {
  const Handle handle = build.create(kind);
  auto& sway = build.as<Sway>(handle);
  sway.time = build.now() + build.lead();
  sway.period = 2.0F;
  sway.radians = 0.3F;
  const EntityLayout& layout = build.pools().layout(handle);
  auto* const shares = reinterpret_cast<float*>(build.pools().block(handle) + layout.private_offset);
  for (int bone = 0; bone < test_character()->skeleton.bone_count(); ++bone) shares[bone] = bone % 3 == 0 ? 1.0F : 0.5F;
  return handle;
}

/// Half a clip, half a sway.
CrowdRig swaying(const SystemOptions& options, std::uint32_t agents = 3) {
  CrowdRig crowd(options, agents);
  const EntityPools::Kind kind = *crowd->characters().add_entity_kind(sway_kind);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    const Status added =
        crowd->agent(agent).add_channel(std::make_unique<FixedChannel>([kind](const EntityBuilder& build) {
          const Handle player = build.player({.clip = 2});
          const Handle sway = make_sway(build, kind);
          return std::vector{player, sway, build.hold(player, sway, 0.5F)};
        }));
    EXPECT_TRUE(added) << added.error().message;
  }
  return crowd;
}

TEST(UserEntity, IsASourceOfABlenderAsPlayersAre) {
  CrowdRig crowd = swaying({});
  CrowdRig plain({}, 3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) plain->agent(agent).play({.clip = 2});
  crowd.step(30);
  plain.step(30);
  EXPECT_EQ(crowd.bones_unlike(plain).size(), static_cast<std::size_t>(test_character()->skeleton.bone_count()));
  EXPECT_EQ(crowd.depth(), 2U);
}

TEST(UserEntity, IsToldApartFromOursByNothing) {
  for (const int pus : {1, 3}) {
    CrowdRig fused = swaying({.pus = pus});
    CrowdRig levels = swaying({.pus = pus, .schedule = Schedule::levels});
    fused.step(100);
    levels.step(100);
    EXPECT_EQ(fused->figures().pose_hash(), levels->figures().pose_hash());
  }
}

TEST(UserEntity, HasAPoolOfItsOwn) {
  CrowdRig crowd = swaying({}, 5);
  const EntityPools& pools = crowd->characters().pools(0);
  const EntityPools::Kind kind = pools.kind_count() - 1;
  EXPECT_STREQ(pools.layout(kind).kind->name, "sway");
  EXPECT_EQ(pools.pool(kind).alive_count(), 5U);
  EXPECT_EQ(pools.layout(kind).total_size, 128U + 192U) << "40 bones: three packets of shares";
  crowd->set_agent_count(2);
  EXPECT_EQ(pools.pool(kind).alive_count(), 2U);
}

TEST(UserEntity, IsFetchedWholeUnlessItsKindSaysWhatItDoesNotRead) {
  CrowdRig crowd = swaying({}, 1);
  crowd.step();
  const EntityPools& pools = crowd->characters().pools(0);
  const std::uint64_t changing = entity_header_bytes - identity_bytes;  // of the player and the blender
  EXPECT_EQ(crowd->figures().report().copies.bytes_in, 2 * changing + pools.layout(pools.kind_count() - 1).total_size);
}

TEST(UserEntity, IsRewoundWithAllOthers) {
  CrowdRig crowd = swaying({});
  crowd.step(17);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(50);
  const std::uint64_t hash = crowd->figures().pose_hash();
  ASSERT_TRUE(crowd->restore(snapshot));
  crowd.step(50);
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
}

TEST(UserEntity, OfAKindThatIsNewSinceASnapshotKeepsItFromBeingRestored) {
  CrowdRig crowd;
  crowd->agent(0).play({.clip = 0});
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  ASSERT_TRUE(crowd->characters().add_entity_kind(sway_kind));
  const Status restored = crowd->restore(snapshot);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().message, "kinds of entities were added since this snapshot: take another one");
}

}  // namespace
}  // namespace throng::anim::user_entity_test
