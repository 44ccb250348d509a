#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace throng::c {

/// The sizes that a struct of throng/c.h has had, oldest first. A version that adds a member adds a size, so such
/// structs have no padding at their end.
template <typename C>
inline constexpr std::array known_sizes{sizeof(C)};

template <typename C>
bool is_known_size(std::size_t size) {
  return std::ranges::count(known_sizes<C>, size) > 0;
}

/// Returns a struct of a known size, with values of `defaults` in the members that the struct is too small for.
template <typename C>
C completed(const C* given, C defaults) {
  std::memcpy(&defaults, given, given->size);
  return defaults;
}

/// Writes the members that `into`, a struct of a known size, has room for.
template <typename C>
void write_known(const C& from, C* into) {
  const std::uint32_t size = into->size;
  std::memcpy(into, &from, size);
  into->size = size;
}

}  // namespace throng::c
