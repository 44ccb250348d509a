#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "engine/anim/entity/clip_streams.h"
#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/keyframe/keyframe_player.h"

namespace throng::anim {

/// Plays one clip: an animation state with a position in an animation stream (paper 2.2.2).
///
/// Its position, and with it its pose, is a closed form of the time that passed. `speed` may have any sign and any
/// size. A looping clip wraps as often as it takes; another clip holds its end. Data keys and displacement are closed
/// forms of two positions (asset/data_keys.h, asset/root_curve.h), so callers ask for the interval between two clock
/// times, and a player that is posed ahead of the clock delivers nothing early or twice.
///
///     [header 96 | player 32 | transforms if resident | interpolation structures if it plays a KeyframeStream]
struct alignas(64) Player {
  static constexpr std::uint32_t looping = 1;
  static constexpr std::uint32_t reached_end =
      2;  ///< holds the end of a clip that does not loop, or wrapped in this update
  static constexpr std::uint32_t leads_step = 4;  ///< its data keys speak for players of its blend that are in_step
  static constexpr std::uint32_t in_step = 8;     ///< meets the data keys that it shares with the leader with it
  static constexpr std::uint32_t every_bone = 0;

  AnimationStateHeader state;    //   0
  FineTicks position;            //  96  once updated in the clip, or beyond its end if it does not loop
  std::uint32_t clip;            // 104  index into the character's clips
  std::int32_t speed;            // 108  1/65536 of the clip's own
  std::uint32_t flags;           // 112
  std::int32_t loop_count;       // 116  whole loops since it started
  KeyframeCursor cursor;         // 120
  std::uint32_t bone_selection;  // 124  every_bone, or 1 + index of a BoneSelection (3.2, per-bone priorities)
};
static_assert(sizeof(Player) == entity_header_bytes);
static_assert(offsetof(Player, position) == 96 && offsetof(Player, flags) == 112 && offsetof(Player, cursor) == 120);
static_assert(offsetof(Player, bone_selection) == 124);

/// Returns how far a player of this speed gets in a time: their product, or the middle of FineTicks on its side, as
/// after 27 hours at the clip's own speed, so that a position can be added.
inline FineTicks distance(Ticks time, std::int32_t speed) {
  constexpr Ticks surely_fits{std::int64_t{1} << 31U};
  if (time < surely_fits && time > -surely_fits) [[likely]]
    return time.count() * speed;
  constexpr FineTicks most = FineTicks{1} << 62;
  const std::int64_t longest = most / std::max<FineTicks>(std::abs(FineTicks{speed}), 1);
  return std::clamp(time.count(), -longest, longest) * speed;
}

/// Uses up `state.delta_time` and moves position, loop count, flags and velocity: the first half of an update (2.2.3).
void advance_player(Player& player, const ClipStreams& clip);

/// Returns where an updated player stands in its clip, from 0 to its duration.
FineTicks position_in_clip(const Player& player, Ticks duration);

extern const EntityKind sampled_player_kind;
extern const EntityKind keyframe_player_kind;

}  // namespace throng::anim
