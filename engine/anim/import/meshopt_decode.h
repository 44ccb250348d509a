#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace throng::import {

/// A buffer view as EXT_meshopt_compression describes it.
struct MeshoptView {
  std::span<const std::byte> bytes;
  std::uint64_t count = 0;   ///< elements
  std::uint64_t stride = 0;  ///< bytes an element
  std::string mode;          ///< ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;        ///< NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

/// count * stride bytes. Checks that so few bytes can hold so many elements before it allocates. Throws Refusal.
std::vector<std::byte> decode_meshopt(const MeshoptView& view);

}  // namespace throng::import
