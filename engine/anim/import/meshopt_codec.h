#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace throng::import {

/// A buffer view as EXT_meshopt_compression or KHR_meshopt_compression describes it.
struct MeshoptView {
  std::span<const std::byte> bytes;
  std::uint64_t count = 0;   ///< elements
  std::uint64_t stride = 0;  ///< bytes an element
  std::string mode;          ///< ATTRIBUTES, TRIANGLES, INDICES
  std::string filter;        ///< NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL, COLOR
};

/// Decodes count * stride bytes. Before it allocates, it checks that the bytes can hold so many elements. Throws
/// Refusal.
std::vector<std::byte> decode_meshopt(const MeshoptView& view);

}  // namespace throng::import
