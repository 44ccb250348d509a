#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/keyframe_player.h"

namespace throng::anim {

/// A player's position is counted in 1/65536 ticks, so that speed times time is exact: where a player stands does not
/// depend on how the time was cut into steps.
using FineTicks = std::int64_t;
inline constexpr FineTicks fine_ticks_per_tick = 65536;

/// The read-only resource of one clip, in main memory (paper 2.2.2 "pointer to the animation stream").
struct ClipStreams {
  const KeyframeStream* keyframe = nullptr;
  const SampledStream* sampled = nullptr;  ///< null: the clip plays from its keyframe stream
  Ticks duration = 0;
  float linear_velocity[3] = {};  ///< metres a second at speed 1: the root motion that was taken out of the pose
};

/// Paper 2.2.2. Plays one clip: an animation state with a position in an animation stream.
///
///     [header 96 | player 32 | transforms if resident | interpolation structures if it plays a KeyframeStream]
struct alignas(64) Player {
  static constexpr std::uint32_t looping = 1;
  static constexpr std::uint32_t reached_end =
      2;  ///< at an end of a clip that does not loop, or wrapped in this update

  AnimationStateHeader state;   //   0
  FineTicks position;           //  96  in the clip, 0 to its duration once updated
  std::uint32_t clip;           // 104  index into the character's clips
  std::int32_t speed;           // 108  1/65536 of the clip's own
  std::uint32_t flags;          // 112
  std::int32_t loop_count;      // 116  whole loops since it started
  KeyframeCursor cursor;        // 120
  std::uint32_t next_data_key;  // 124
};
static_assert(sizeof(Player) == entity_header_bytes);
static_assert(offsetof(Player, position) == 96 && offsetof(Player, flags) == 112 && offsetof(Player, cursor) == 120);

/// Update step, first half (2.2.3): uses up `state.delta_time` and moves the position, loop count, flags and velocity.
void advance_player(Player& player, const ClipStreams& clip);

/// Second half: what its packets of 16 bones are made from. A player of a SampledStream keeps only its position; one of
/// a KeyframeStream brings its interpolation structures along once, before its first packet.
struct PlayerPose {
  const ClipStreams* clip = nullptr;
  Ticks time = 0;
  SamplePoint point;                    ///< sampled
  std::span<std::byte> interpolations;  ///< keyframe
};
PlayerPose begin_pose(Player& player, const ClipStreams& clip, std::span<std::byte> interpolations);

extern const EntityKind sampled_player_kind;
extern const EntityKind keyframe_player_kind;

}  // namespace throng::anim
