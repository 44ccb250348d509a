#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A named moment of a clip for game play: a foot lands, a hand lets go (paper 2.2.2).
struct DataKey {
  Ticks time{};            ///< from 0 to the clip's duration
  std::uint32_t name = 0;  ///< index into Character::data_key_names
};

/// The keys that a motion within one loop of a clip meets.
struct DataKeyRun {
  std::size_t first = 0;  ///< the key that is met first: backward, the latest one
  std::size_t count = 0;
};
/// Finds the keys between two positions, in fine ticks: 0 <= `low` < `high` <= `duration`.
DataKeyRun data_keys_between(std::span<const DataKey> keys, FineTicks duration, FineTicks low, FineTicks high,
                             bool forward);

/// Rounds down: a player that moves backwards is in loop -1 as soon as it leaves 0.
constexpr FineTicks whole_loops(FineTicks position, FineTicks duration) {
  const FineTicks quotient = position / duration;
  return position % duration < 0 ? quotient - 1 : quotient;
}

/// Calls visit(key, position) for every data key that a motion `from` -> `to` meets, in the order of the motion, until
/// it returns false. `keys` are sorted by time. Positions are unwrapped: in a looping clip they may lie any number of
/// loops ahead or back; in others they are held at the clip's ends.
///
/// A motion meets a key when it leaves it: forward in [from, to), backward in (to, from]. A motion that is cut into
/// steps therefore meets the same keys as the whole. No step leaves the keys at a clip's two ends, so they are met just
/// inside: the key at the duration just before the end, the key at 0 just after the start. Arriving at an end
/// therefore delivers that end's key, and standing there delivers nothing. At the seam of a loop the key at the
/// duration comes before the key at 0, or after it when time runs backwards.
///
/// Takes time for the keys that it delivers, not for loops or keys that it passes over.
template <typename Visit>
void for_each_data_key(std::span<const DataKey> keys, Ticks duration, bool looping, FineTicks from, FineTicks to,
                       Visit&& visit) {
  const FineTicks length = duration * fine_ticks_per_tick;
  const auto held = [&](FineTicks position) { return position < 0 ? 0 : (position > length ? length : position); };
  if (!looping) {
    from = held(from);
    to = held(to);
  }
  if (keys.empty() || duration <= Ticks{} || from == to) return;
  const bool forward = from < to;
  const FineTicks low = forward ? from : to;
  const FineTicks high = forward ? to : from;
  const FineTicks first_loop = whole_loops(low, length);
  const FineTicks last_loop = whole_loops(high - 1, length);
  for (FineTicks i = 0; i <= last_loop - first_loop; ++i) {
    const FineTicks start = (forward ? first_loop + i : last_loop - i) * length;
    const DataKeyRun run = data_keys_between(keys, length, held(low - start), held(high - start), forward);
    for (std::size_t k = 0; k < run.count; ++k) {
      const DataKey& key = keys[forward ? run.first + k : run.first - k];
      if (!visit(key, start + key.time * fine_ticks_per_tick)) return;
    }
  }
}

}  // namespace throng::anim
