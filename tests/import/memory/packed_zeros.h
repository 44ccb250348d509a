#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// Streams of a few bytes that decode to many.

namespace throng::import::testing {

/// Returns a PNG of zeros whose header says so many pixels of one bit, or of four channels of a byte. `more` bytes
/// follow what the header promises in its stream.
std::vector<char> png_of_zeros(std::uint32_t width, std::uint32_t height, bool has_channels, std::size_t more = 0);

/// Returns a grey JPEG whose header says so many pixels, and which ends where they begin.
std::vector<char> jpeg_of_zeros(std::uint16_t width, std::uint16_t height);

/// Returns a lossless WebP all of whose pixels take no bit.
std::vector<char> webp_of_zeros(std::uint32_t width, std::uint32_t height);

/// Returns `count` elements of 64 zeros each, packed by meshoptimizer.
std::vector<char> meshopt_of_zeros(std::size_t count);

/// Returns a flat square of side * side * 2 triangles, packed by Draco. Its positions have the unique id 0. Each vertex
/// has `channels` zeros besides, at most 100.
std::vector<char> draco_square(std::uint32_t side, std::int8_t channels = 0);

}  // namespace throng::import::testing
