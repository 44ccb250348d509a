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

/// Returns the size of the bytes that a view decodes to. Checks that its own bytes can hold so many. Throws Refusal.
std::uint64_t decoded_meshopt_size(const MeshoptView& view);

/// Decodes count * stride bytes, after the same check. Throws Refusal.
std::vector<std::byte> decode_meshopt(const MeshoptView& view);

}  // namespace throng::import
