#pragma once

#include "engine/anim/api/c/parts.h"

namespace throng::c {

static_assert(THRONG_KEYS_ALL == static_cast<int>(KeyChoice::all));

inline bool is_choice(const Call& call, std::uint32_t choice) {
  return call.is_constant("the choice of keys", choice, KeyChoice::all);
}

inline throng_key c_key_of(const DataKey& key) {
  return {.name = key.name, .clip = key.clip.number, .time = to_seconds(key.time), .weight = key.weight};
}

}  // namespace throng::c
