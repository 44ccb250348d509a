#pragma once

#include <cstddef>
#include <span>

namespace throng::import {

/// Says whether a stream of attributes has the format that KHR_meshopt_compression adds to the format of
/// EXT_meshopt_compression.
bool is_attribute_stream_v1(std::span<const std::byte> bytes);

/// Decodes a stream of attributes of version 1 (KHR_meshopt_compression, appendix A, mode 0) into `elements`, a whole
/// number of elements of `stride` bytes, which is a multiple of 4 up to 256. Throws Refusal where the stream ends too
/// early or too late, or has modes that there are not.
void decode_attributes_v1(std::span<const std::byte> bytes, std::size_t stride, std::span<std::byte> elements);

/// Applies the filter COLOR (appendix B, filter 4) to elements of four components, of 1 or 2 bytes each.
void decode_color_filter(std::span<std::byte> elements, std::size_t stride);

}  // namespace throng::import
