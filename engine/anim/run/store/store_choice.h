#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// How palettes are best written, by how many bytes of them there are. What is still in the caches when it is written
/// again is written fastest where it lies, and whoever reads it next finds it there. What is not would be fetched from
/// memory only to be overwritten: it is written past the caches, on machines where that is faster.

/// Up to so many bytes are written fastest where they lie, or within a tenth of that: a power of two, from
/// least_cached_bytes to below most_measured_bytes, or any_bytes. Measured when it is first asked for, in some tenths
/// of a second and with twice as much memory for as long: what a machine says of its caches is not what it lends to one
/// program.
std::size_t cached_bytes();
inline constexpr std::size_t least_cached_bytes = std::size_t{8} << 20U;
inline constexpr std::size_t most_measured_bytes = std::size_t{128} << 20U;
inline constexpr std::size_t any_bytes = SIZE_MAX;  ///< most_measured_bytes are, which hardly a cache lends

/// The same by what such a measurement says of so many bytes.
std::size_t cached_bytes(const std::function<bool(std::size_t bytes)>& are_faster_where_they_lie);

/// What goes through the caches until a palette is written again: blocks and streams take a quarter of what palettes
/// do.
constexpr std::size_t bytes_of_an_update(std::size_t palette_bytes) { return palette_bytes + palette_bytes / 4; }

/// For that many bytes of palettes; the machine is measured only if an update of them has more than least_cached_bytes.
StorePolicy store_policy_for(std::size_t palette_bytes);

}  // namespace throng::anim
