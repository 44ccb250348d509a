// Entities of one kind that stand side by side in a local store are advanced by one call.

#include "engine/anim/entity/entity_run.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_layout.h"
#include "engine/anim/entity/held_state.h"
#include "engine/anim/entity/player.h"

namespace throng::anim::entity_run_test {
namespace {

constexpr std::size_t characters = 3;

/// The block of one character's entity, and what is prepared for it.
template <typename Entity>
struct alignas(64) Slot {
  Entity entity;
  std::byte prepared[64];
};
template <typename Entity>
using Slots = std::array<Slot<Entity>, characters>;

class RunOfEntities : public testing::Test {
 protected:
  RunOfEntities() {
    for (const BakedClip& clip : character_.clips) {
      clips_.push_back({.keyframe = clip.keyframe(), .sampled = clip.sampled(), .duration = clip.duration});
    }
    assets_.clips = clips_;
  }

  /// Each in another clip, at another place and speed.
  Slots<Player> players(std::uint32_t first_clip) const {
    Slots<Player> slots{};
    for (std::uint32_t i = 0; i < characters; ++i) {
      Player& player = slots[i].entity;
      player.clip = (first_clip + i) % static_cast<std::uint32_t>(clips_.size());
      player.position = clips_[player.clip].duration * fine_ticks_per_tick / 2;
      player.speed = (static_cast<std::int32_t>(i) - 1) * 65536;
      player.flags = Player::looping;
      player.state.delta_time = (i + 1) * ticks_per_second / 60;
    }
    return slots;
  }
  Slots<EaseBlender> blenders(const std::array<float, characters>& fractions) const {
    Slots<EaseBlender> slots{};
    for (std::size_t i = 0; i < characters; ++i) {
      slots[i].entity.flags = EaseBlender::held;
      slots[i].entity.mask = EaseBlender::no_mask;
      slots[i].entity.fraction = fractions[i];
    }
    return slots;
  }

  template <typename Entity>
  EntityRun run_of(Slots<Entity>& slots, const EntityLayout& layout) const {
    return {.first = {.block = reinterpret_cast<std::byte*>(&slots[0].entity),
                      .prepared = slots[0].prepared,
                      .layout = &layout,
                      .assets = &assets_},
            .count = characters,
            .block_stride = sizeof slots[0],
            .prepared_stride = sizeof slots[0]};
  }
  template <typename Entity>
  static SourceRow row_of(const Slots<Entity>& slots, const std::array<ShownClips, characters>& shown) {
    return {reinterpret_cast<const std::byte*>(&slots[0].entity), sizeof slots[0], shown.data()};
  }

  const Character character_ = bake_character(synthetic_model(20, 2));
  std::vector<ClipStreams> clips_;
  EntityAssets assets_;
  const EntityLayout player_layout_ = layout_of(sampled_player_kind);
  const EntityLayout blender_layout_ = layout_of(ease_blender_kind);
  const EntityLayout held_layout_ = layout_of(held_state_kind);

 private:
  static EntityLayout layout_of(const EntityKind& kind) {
    return entity_layout(kind, Residency::transient, 20, rigid_components);
  }
};

TEST_F(RunOfEntities, IsAdvancedAsIfEachWereAlone) {
  Slots<Player> together = players(0);
  Slots<Player> alone = players(0);
  sampled_player_kind.advance(run_of(together, player_layout_));
  for (std::size_t i = 0; i < characters; ++i) {
    sampled_player_kind.advance({.first = run_of(alone, player_layout_).entity(i)});
    EXPECT_EQ(together[i].entity.position, alone[i].entity.position) << i;
    EXPECT_EQ(together[i].entity.loop_count, alone[i].entity.loop_count) << i;
    EXPECT_EQ(together[i].entity.flags, alone[i].entity.flags) << i;
    EXPECT_EQ(together[i].entity.state.delta_time, Ticks{}) << i;
  }
}

TEST_F(RunOfEntities, TakesTheTimeThatPassesBesideTheTimeThatIsThere) {
  Slots<Player> handed = players(0);
  Slots<Player> there = players(0);
  const std::array<Ticks, characters> deltas = {Ticks{1'000}, Ticks{0}, Ticks{250'000}};
  for (std::size_t i = 0; i < characters; ++i) there[i].entity.state.delta_time += deltas[i];
  EntityRun run = run_of(handed, player_layout_);
  run.deltas = deltas.data();
  sampled_player_kind.advance(run);
  sampled_player_kind.advance(run_of(there, player_layout_));
  for (std::size_t i = 0; i < characters; ++i) {
    EXPECT_EQ(handed[i].entity.position, there[i].entity.position) << i;
    EXPECT_EQ(handed[i].entity.state.delta_time, Ticks{}) << i;
  }
}

TEST_F(RunOfEntities, OfAKindThatNeverShowsClipsSaysSo) {
  Slots<HeldState> slots{};
  const ClipMoment stale;
  std::array<ShownClips, characters> shown;
  shown.fill({.clip = &stale, .blended = &stale});
  EntityRun run = run_of(slots, held_layout_);
  run.shown = shown.data();
  held_state_kind.advance(run);
  for (const ShownClips& each : shown) {
    EXPECT_EQ(each.clip, nullptr);
    EXPECT_EQ(each.blended, nullptr);
  }
}

TEST_F(RunOfEntities, ThatArePlayersShowTheClipOfEach) {
  Slots<Player> slots = players(0);
  std::array<ShownClips, characters> shown{};
  EntityRun run = run_of(slots, player_layout_);
  run.shown = shown.data();
  sampled_player_kind.advance(run);
  for (std::size_t i = 0; i < characters; ++i) {
    const Player& player = slots[i].entity;
    const SamplePoint point = locate(*clips_[player.clip].sampled, player.position / fine_ticks_per_tick);
    ASSERT_NE(shown[i].clip, nullptr) << i;
    EXPECT_EQ(shown[i].clip->stream, clips_[player.clip].sampled) << i;
    EXPECT_EQ(shown[i].clip->point.from, point.from) << i;
    EXPECT_EQ(shown[i].clip->point.weights, point.weights) << i;
    EXPECT_EQ(shown[i].blended, nullptr) << i;
  }
}

TEST_F(RunOfEntities, ThatAreBlendersShowBothClipsOrTheOneThatIsLeft) {
  Slots<Player> from = players(0);
  Slots<Player> to = players(1);
  std::array<ShownClips, characters> shown_from{}, shown_to{}, shown{};
  EntityRun from_run = run_of(from, player_layout_);
  EntityRun to_run = run_of(to, player_layout_);
  from_run.shown = shown_from.data();
  to_run.shown = shown_to.data();
  sampled_player_kind.advance(from_run);
  sampled_player_kind.advance(to_run);
  const std::array<SourceRow, 2> sources = {row_of(from, shown_from), row_of(to, shown_to)};
  Slots<EaseBlender> slots = blenders({0.0F, 0.25F, 1.0F});
  EntityRun run = run_of(slots, blender_layout_);
  run.sources = sources;
  run.shown = shown.data();
  ease_blender_kind.advance(run);
  EXPECT_EQ(shown[0].clip, shown_from[0].clip);
  EXPECT_EQ(shown[0].blended, nullptr);
  EXPECT_EQ(shown[1].clip, shown_from[1].clip);
  EXPECT_EQ(shown[1].blended, shown_to[1].clip);
  EXPECT_EQ(shown[1].fraction, 0.25F);
  EXPECT_EQ(shown[2].clip, shown_to[2].clip);
  EXPECT_EQ(shown[2].blended, nullptr);
}

}  // namespace
}  // namespace throng::anim::entity_run_test
