#pragma once

#include "app/output/regression/compare.h"

namespace throng::render::test {

using app::measure_difference;
using app::PictureDifference;

// Software rasterisers round edges differently on processors with and without wide vectors. These two numbers, in steps
// of 255, forgive the single pixels along outlines that differ.

/// The largest mean of all pixels. It is above this if light, fog or exposure changed.
inline constexpr double largest_mean_difference = 0.6;
/// The largest mean of the worst 16x16 block. A missing hand changes its block by 20 and more, pixels of an outline by
/// up to 5.
inline constexpr double largest_block_difference = 8.0;

inline bool looks_the_same(const PictureDifference& difference) {
  return difference.mean <= largest_mean_difference && difference.worst_block <= largest_block_difference;
}

}  // namespace throng::render::test
