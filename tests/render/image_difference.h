#pragma once

#include "engine/render/image.h"

namespace throng::render::test {

/// Measures how far two pictures of one size are apart, in steps of 255 a channel, without alpha.
struct ImageDifference {
  double mean = 0.0;         ///< the mean over all pixels
  double worst_block = 0.0;  ///< the largest mean of a 16x16 block: one missing hand shows here
  int worst_block_x = 0;     ///< pixels: the corner of that block
  int worst_block_y = 0;
  Image picture;  ///< the absolute difference, eight times as bright
};

/// Measures the difference. Errors: the sizes differ.
Result<ImageDifference> compare(const Image& expected, const Image& actual);

}  // namespace throng::render::test
