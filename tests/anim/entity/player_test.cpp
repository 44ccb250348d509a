#include "engine/anim/entity/player.h"

#include <random>

#include <gtest/gtest.h>

#include "engine/anim/entity/entity_layout.h"

namespace throng::anim::player_test {
namespace {

constexpr Ticks second = ticks_per_second;

Player player_at(Ticks position, double speed, std::uint32_t flags) {
  Player player{};
  player.position = position * fine_ticks_per_tick;
  player.speed = static_cast<std::int32_t>(speed * 65536.0);
  player.flags = flags;
  return player;
}

void advance(Player& player, const ClipStreams& clip, Ticks delta) {
  player.state.delta_time = delta;
  advance_player(player, clip);
}

Ticks position(const Player& player) { return player.position / fine_ticks_per_tick; }

TEST(Player, UsesUpItsDeltaTime) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 1.0, Player::looping);
  advance(player, clip, second / 4);
  EXPECT_EQ(position(player), second / 4);
  EXPECT_EQ(player.state.delta_time, Ticks{});
}

TEST(Player, MovesAtItsSpeed) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 0.5, Player::looping);
  advance(player, clip, second);
  EXPECT_EQ(position(player), second / 2);
}

TEST(Player, LoopsAndSaysSoOnce) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 1.0, Player::looping);
  advance(player, clip, 2 * second + second / 4);
  EXPECT_EQ(position(player), second / 4);
  EXPECT_EQ(player.loop_count, 2);
  EXPECT_TRUE(player.flags & Player::reached_end);
  advance(player, clip, second / 4);
  EXPECT_FALSE(player.flags & Player::reached_end);
}

TEST(Player, LoopsBackwardsAlike) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, -1.0, Player::looping);
  advance(player, clip, second / 4);
  EXPECT_EQ(position(player), second * 3 / 4);
  EXPECT_EQ(player.loop_count, -1);
}

TEST(Player, HoldsAtTheEndOfAClipThatDoesNotLoop) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 1.0, 0);
  advance(player, clip, 3 * second);
  EXPECT_EQ(position_in_clip(player, second) / fine_ticks_per_tick, second);
  EXPECT_TRUE(player.flags & Player::reached_end);
}

TEST(Player, RemembersHowFarBeyondItsEndItHasBeen) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 1.0, 0);
  advance(player, clip, 3 * second);
  advance(player, clip, -second * 5 / 2);
  EXPECT_EQ(position(player), second / 2) << "wound back, it stands where it stood then";
  EXPECT_FALSE(player.flags & Player::reached_end);
}

TEST(Player, StaysNearItsEndHoweverLongItHolds) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(Ticks{}, 1.0, 0);
  for (int day = 0; day < 30; ++day) advance(player, clip, 24 * 3600 * second);
  EXPECT_LE(position(player), 3601 * second);
}

TEST(Player, StandsInAClipWithoutDuration) {
  const ClipStreams clip{.duration = {}};
  Player player = player_at(Ticks{}, 1.0, Player::looping);
  advance(player, clip, second);
  EXPECT_EQ(position_in_clip(player, Ticks{}), 0);
}

TEST(Player, WhereItStandsDoesNotDependOnHowTimeWasCutIntoSteps) {
  const ClipStreams clip{.duration = second * 7 / 5 + Ticks{3}};
  Player in_one_step = player_at(Ticks{1234}, 1.2345, Player::looping);
  Player in_many = in_one_step;
  std::mt19937 random(7);
  Ticks total{};
  for (int i = 0; i < 10'000; ++i) {
    const Ticks step{static_cast<std::int64_t>(random() % static_cast<std::uint32_t>((second / 20).count()))};
    advance(in_many, clip, step);
    total += step;
  }
  advance(in_one_step, clip, total);
  EXPECT_EQ(in_many.position, in_one_step.position);
  EXPECT_EQ(in_many.loop_count, in_one_step.loop_count);
}

TEST(Player, CarriesTheVelocityOfItsClip) {
  const RootCurve walk = straight_root_curve(second, {0.0, 0.0, 1.4});
  const ClipStreams clip{.duration = second, .root_motion = &walk};
  Player player = player_at(Ticks{}, 0.5, Player::looping);
  advance(player, clip, second / 60);
  EXPECT_FLOAT_EQ(player.state.linear_velocity[2], 0.7F);
}

TEST(Player, HoldsTheStartOfAClipThatItPlaysBackwards) {
  const ClipStreams clip{.duration = second};
  Player player = player_at(second, -2.0, 0);
  advance(player, clip, second / 4);
  EXPECT_EQ(position(player), second / 2);
  EXPECT_FALSE(player.flags & Player::reached_end);
  advance(player, clip, second / 4);
  EXPECT_EQ(position_in_clip(player, second), 0);
  EXPECT_TRUE(player.flags & Player::reached_end) << "as one that comes to the very end forwards";
  advance(player, clip, second);
  EXPECT_EQ(position_in_clip(player, second), 0);
}

TEST(Player, IsAClosedFormOfTimeWhateverItsSpeed) {
  const ClipStreams clip{.duration = second / 3 + Ticks{1}};
  const FineTicks start = second / 7 * fine_ticks_per_tick;
  for (const double speed : {-100.0, -1.7, -1.0 / 65536.0, 0.0, 0.3, 1.0, 250.0}) {
    Player player = player_at(second / 7, speed, Player::looping);
    std::mt19937 random(13);
    Ticks total{};
    for (int i = 0; i < 500; ++i) {
      const Ticks step{static_cast<std::int64_t>(random() % static_cast<std::uint32_t>(second.count()))};
      advance(player, clip, step);
      total += step;
      ASSERT_EQ(player.loop_count * clip.duration * fine_ticks_per_tick + player.position,
                start + total.count() * player.speed)
          << speed;
      ASSERT_GE(player.position, 0);
      ASSERT_LT(player.position, clip.duration * fine_ticks_per_tick);
    }
  }
}

/// Walks forward for half a second, then turns left on the spot.
RootCurve walk_and_turn() {
  return {.duration = second, .keys = {{}, {.time = second / 2, .z = 0.7}, {.time = second, .z = 0.7, .yaw = 0.5}}};
}

TEST(Player, HasTheVelocityOfItsRootMotionWhereItStands) {
  const RootCurve curve = walk_and_turn();
  const ClipStreams clip{.duration = second, .root_motion = &curve};
  Player player = player_at(Ticks{}, -2.0, Player::looping);
  advance(player, clip, second / 8);
  EXPECT_FLOAT_EQ(player.state.linear_velocity[2], 0.0F);
  EXPECT_FLOAT_EQ(player.state.angular_velocity[1], -2.0F) << "backwards it turns right";
  advance(player, clip, second / 4);
  EXPECT_FLOAT_EQ(player.state.linear_velocity[2], -2.8F);
  EXPECT_FLOAT_EQ(player.state.angular_velocity[1], 0.0F);
}

TEST(Player, ThatHoldsAnEndStandsStill) {
  const RootCurve curve = walk_and_turn();
  const ClipStreams clip{.duration = second, .root_motion = &curve};
  Player player = player_at(second * 3 / 4, 1.0, 0);
  advance(player, clip, second / 8);
  EXPECT_FLOAT_EQ(player.state.angular_velocity[1], 1.0F);
  advance(player, clip, second);
  EXPECT_FLOAT_EQ(player.state.angular_velocity[1], 0.0F);
}

TEST(EntityLayout, ATransientPlayerIsTwoCacheLines) {
  const EntityLayout layout = entity_layout(sampled_player_kind, Residency::transient, 62, rigid_components);
  EXPECT_EQ(layout.total_size, 128U);
  EXPECT_EQ(layout.transforms_offset, 0U);
  EXPECT_EQ(layout.total_size - identity_bytes, 64U) << "at most 64 bytes of a transient entity change in a frame";
}

TEST(EntityLayout, OfATransientBlockTheFirstLineIsFetchedForWhoReadsIt) {
  EntityKind kind = sampled_player_kind;
  const auto unread = [&](Residency residency) {
    return entity_layout(kind, residency, 62, rigid_components).unread_bytes();
  };
  EXPECT_EQ(unread(Residency::transient), identity_bytes);
  EXPECT_EQ(unread(Residency::resident), 0U) << "says where the transforms are";
  kind.reads_identity = EntityKind{}.reads_identity;
  EXPECT_EQ(unread(Residency::transient), 0U) << "a host's kind gets it unless it says that it needs none";
}

TEST(EntityLayout, AResidentKeyframePlayerOf62BonesFitsTheFetchBufferOf8KiBThatThePaperHas) {
  const EntityLayout layout = entity_layout(keyframe_player_kind, Residency::resident, 62, rigid_components);
  EXPECT_EQ(layout.transforms_offset, 128U);
  EXPECT_EQ(layout.source_bytes(), 128U + 1792U);
  EXPECT_LE(layout.total_size, 8192U);
  EXPECT_LE(layout.private_bytes(), 64U * 80U);
}

TEST(EntityLayout, ConversionKeepsAllButTheTransforms) {
  const EntityLayout transient = entity_layout(keyframe_player_kind, Residency::transient, 62, rigid_components);
  const EntityLayout resident = entity_layout(keyframe_player_kind, Residency::resident, 62, rigid_components);
  const AlignedBytes from = allocate_aligned(transient.total_size);
  const AlignedBytes to = allocate_aligned(resident.total_size);
  auto& player = *reinterpret_cast<Player*>(from.get());
  initialise_state(player.state, transient, 62, rigid_components);
  player.position = 42;
  from[transient.private_offset + 5] = std::byte{9};
  convert_residency(from.get(), to.get(), transient, resident);
  const auto& converted = *reinterpret_cast<const Player*>(to.get());
  EXPECT_EQ(converted.position, 42);
  EXPECT_EQ(converted.state.transforms_offset, resident.transforms_offset);
  EXPECT_EQ(converted.state.total_size, resident.total_size);
  EXPECT_EQ(to[resident.private_offset + 5], std::byte{9});
}

}  // namespace
}  // namespace throng::anim::player_test
