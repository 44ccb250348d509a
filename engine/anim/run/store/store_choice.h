#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// Decides how palettes are written, by how many bytes of them there are. Lines that are still in the caches when they
/// are written again are written fastest where they lie, and the next reader finds them there. Other lines would be
/// fetched from memory only to be overwritten, so they are written past the caches on machines where that is faster.

/// Returns the bytes that the machine says its caches hold for one program: a quarter of its last level, and at most
/// 32 MiB, since it lends no program the whole level; least_cached_bytes if it says nothing. Takes no time.
std::size_t named_cached_bytes();

/// Returns the most bytes that are written fastest where they lie, or within a tenth of that: a power of two, from
/// least_cached_bytes to below most_measured_bytes, or any_bytes. The first call measures it, in some tenths of a
/// second and with twice as much memory. A host calls it at load time, if at all.
std::size_t measured_cached_bytes();
inline constexpr std::size_t least_cached_bytes = std::size_t{8} << 20U;
inline constexpr std::size_t most_measured_bytes = std::size_t{128} << 20U;
inline constexpr std::size_t any_bytes = SIZE_MAX;  ///< even most_measured_bytes are written fastest where they lie

/// Returns these bytes by a measurement of the caller's.
std::size_t measured_cached_bytes(const std::function<bool(std::size_t bytes)>& are_faster_where_they_lie);

/// Returns the bytes that go through the caches until a palette is written again. Blocks and streams take a quarter of
/// the palettes' bytes.
constexpr std::size_t bytes_of_an_update(std::size_t palette_bytes) { return palette_bytes + palette_bytes / 4; }

/// Returns the policy for so many bytes of palettes, on a machine whose caches hold `cached_bytes`.
StorePolicy store_policy_for(std::size_t palette_bytes, std::size_t cached_bytes);

}  // namespace throng::anim
