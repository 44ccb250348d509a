#pragma once

#include "engine/render/image.h"

namespace throng::app {

/// Says how far two pictures of one size are apart, in steps of 255 a channel, without alpha.
struct PictureDifference {
  double mean = 0.0;         ///< the mean over all pixels: light that changed everywhere and by little shows here
  double worst_block = 0.0;  ///< the largest mean of a 16x16 block: one missing hand shows here
  int worst_block_x = 0;     ///< pixels: the corner of that block
  int worst_block_y = 0;
  double share = 0.0;  ///< the share of pixels of which a channel is off by more than `seen_steps`

  friend bool operator==(const PictureDifference&, const PictureDifference&) = default;
};

/// A pixel counts as another one if a channel of it is off by more steps of 255 than these.
inline constexpr int seen_steps = 16;

/// Measures the difference. Errors: the sizes differ; the error says both.
render::Result<PictureDifference> measure_difference(const render::Image& expected, const render::Image& actual);

/// Returns the absolute difference of two pictures of one size, eight times as bright.
render::Image paint_difference(const render::Image& expected, const render::Image& actual);

/// Returns the expected picture in grey with what differs in colour: from blue, a step, over yellow to red, 64 steps
/// and more. A frame is around the worst block.
render::Image paint_heat(const render::Image& expected, const render::Image& actual,
                         const PictureDifference& difference);

/// Returns a picture with so many bits a channel, 1 to 8, which compresses the better the fewer they are. White stays.
render::Image rounded_to_bits(render::Image image, int bits);

}  // namespace throng::app
