#pragma once

#include "engine/render/image.h"

namespace throng::render::test {

// Rasterisers of processors with and without wide vectors round edges differently: single pixels along outlines, which
// these two numbers forgive. They are in steps of 255.

/// Everything at once: light, fog or exposure changed.
inline constexpr double largest_mean_difference = 0.6;
/// The worst 16x16 block: a hand that is missing changes its block by 20 and more, an outline's pixels by up to 5.
inline constexpr double largest_block_difference = 8.0;

inline bool looks_the_same(const ImageDifference& difference) {
  return difference.mean <= largest_mean_difference && difference.worst_block <= largest_block_difference;
}

}  // namespace throng::render::test
