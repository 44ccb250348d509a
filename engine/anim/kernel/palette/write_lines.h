#pragma once

#include <cstdint>
#include <span>

namespace throng::anim {

/// The ways in which palettes are written; the values are the same. The fastest way depends on how much is written in
/// all, and on the machine.
enum class StorePolicy : std::uint8_t {
  plain,
  prefetched,  ///< lines are fetched for writing while they are computed
  streaming    ///< past the caches if palettes are 64-byte aligned; not visible to others before fence_stores()
};

/// Writes whole cache lines of one value, in order. It is the lower bound for every kernel that writes palettes, and
/// the probe that tells how palettes are best written (run/store/store_choice.h).
struct WriteLinesJob {
  std::span<float> lines;  ///< out, [16 * lines]
  float value = 0.0F;
  StorePolicy stores = StorePolicy::plain;
};
bool is_valid(const WriteLinesJob& job);

}  // namespace throng::anim
