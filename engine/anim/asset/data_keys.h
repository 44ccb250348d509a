#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A moment of a clip that game play wants to know of: a foot that lands, a hand that lets go (paper 2.2.2).
struct DataKey {
  Ticks time = 0;          ///< 0 to the clip's duration
  std::uint32_t name = 0;  ///< index of Character::data_key_names
};

/// The keys that one run through a clip meets on its way between two of its own positions.
struct DataKeyRun {
  std::size_t first = 0;  ///< in the order of the motion: backward, the later key
  std::size_t count = 0;
};
/// `low` < `high`, both 0 to `duration`, in fine ticks.
DataKeyRun data_keys_between(std::span<const DataKey> keys, FineTicks duration, FineTicks low, FineTicks high,
                             bool forward);

/// Floor division: a player that moves backwards is in loop -1 as soon as it leaves 0.
constexpr FineTicks whole_loops(FineTicks position, FineTicks duration) {
  const FineTicks quotient = position / duration;
  return position % duration < 0 ? quotient - 1 : quotient;
}

/// Calls visit(key, position) for every data key that a motion `from` -> `to` meets, in the order of the motion, until
/// it returns false. Positions are unwrapped: those of a looping clip may lie any number of loops ahead or back; those
/// of one that does not loop are held at its ends. `keys` are sorted by time.
///
/// Intervals are half-open: a key is met as the motion leaves it, forward in [from, to), backward in (to, from]; so a
/// motion cut into steps meets what the whole meets. The keys at a clip's ends are met where no step is left to leave
/// them: the one at its duration just before the end, the one at 0 just after the start. So arriving at an end delivers
/// that end's key, standing there delivers nothing, and where a loop closes the key at the duration comes before the
/// one at 0, or after it when time runs backwards.
///
/// Takes time for the keys that it delivers, not for the loops or keys that it passes over.
template <typename Visit>
void for_each_data_key(std::span<const DataKey> keys, Ticks duration, bool looping, FineTicks from, FineTicks to,
                       Visit&& visit) {
  const FineTicks length = duration * fine_ticks_per_tick;
  const auto held = [&](FineTicks position) { return position < 0 ? 0 : (position > length ? length : position); };
  if (!looping) {
    from = held(from);
    to = held(to);
  }
  if (keys.empty() || duration <= 0 || from == to) return;
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
