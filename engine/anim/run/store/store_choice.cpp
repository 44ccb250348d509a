#include "engine/anim/run/store/store_choice.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <span>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {
namespace {

/// The least time of some rounds, since all that disturbs it makes it longer; so many that the first ones have brought
/// the lines to where that many of them stay.
double seconds_to_write(std::span<float> lines, StorePolicy stores) {
  const int rounds = static_cast<int>(std::max<std::size_t>(4, most_measured_bytes / lines.size_bytes()));
  const Kernels& kernels = best_kernels();
  double least = std::numeric_limits<double>::max();
  for (int round = 0; round < rounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    kernels.write_lines({.lines = lines, .value = static_cast<float>(round), .stores = stores});
    kernels.fence_stores();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/// Stores into the caches win ties: the next reader finds lines there, and a busy neighbour may have taken the caches
/// away for a while.
constexpr double clearly_longer = 1.1;

/// A machine of many programs names caches that no one of them has to itself.
constexpr std::size_t most_named_bytes = std::size_t{32} << 20U;

bool measured_faster_where_they_lie(std::size_t bytes) {
  const AlignedBytes memory = allocate_aligned(bytes);
  const std::span lines(reinterpret_cast<float*>(memory.get()), bytes / sizeof(float));
  const double past_the_caches = seconds_to_write(lines, StorePolicy::streaming);
  return seconds_to_write(lines, StorePolicy::prefetched) < clearly_longer * past_the_caches;
}

}  // namespace

std::size_t measured_cached_bytes(const std::function<bool(std::size_t bytes)>& are_faster_where_they_lie) {
  std::size_t bytes = least_cached_bytes;
  while (are_faster_where_they_lie(2 * bytes)) {
    bytes *= 2;
    if (bytes == most_measured_bytes) return any_bytes;
  }
  return bytes;
}

std::size_t measured_cached_bytes() {
  static const std::size_t bytes = measured_cached_bytes(measured_faster_where_they_lie);
  return bytes;
}

std::size_t named_cached_bytes() {
  long last_level = 0;
#ifdef _SC_LEVEL3_CACHE_SIZE
  last_level = sysconf(_SC_LEVEL3_CACHE_SIZE);
#endif
  return last_level <= 0 ? least_cached_bytes
                         : std::clamp(static_cast<std::size_t>(last_level) / 4, least_cached_bytes, most_named_bytes);
}

StorePolicy store_policy_for(std::size_t palette_bytes, std::size_t cached_bytes) {
  const std::size_t bytes = bytes_of_an_update(palette_bytes);
  return bytes <= std::max(least_cached_bytes, cached_bytes) ? StorePolicy::prefetched : StorePolicy::streaming;
}

}  // namespace throng::anim
