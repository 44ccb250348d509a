#include "engine/anim/asset/data_keys.h"

#include <algorithm>
#include <cassert>

namespace throng::anim {

namespace {

FineTicks fine_time(const DataKey& key) { return key.time * fine_ticks_per_tick; }

}  // namespace

DataKeyRun data_keys_between(std::span<const DataKey> keys, FineTicks duration, FineTicks low, FineTicks high,
                             bool forward) {
  assert(0 <= low && low < high && high <= duration);
  assert(std::ranges::is_sorted(keys, {}, &DataKey::time));
  const auto index = [&](auto place) { return static_cast<std::size_t>(place - keys.begin()); };
  const auto first_from = [&](FineTicks position) {
    return index(std::ranges::lower_bound(keys, position, {}, fine_time));
  };
  const auto first_after = [&](FineTicks position) {
    return index(std::ranges::upper_bound(keys, position, {}, fine_time));
  };
  if (forward) {
    const std::size_t first = first_from(low);
    return {.first = first, .count = (high == duration ? keys.size() : first_from(high)) - first};
  }
  const std::size_t end = first_after(high);
  const std::size_t begin = low == 0 ? 0 : first_after(low);
  return {.first = end - 1, .count = end - begin};
}

}  // namespace throng::anim
