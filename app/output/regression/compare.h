#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "throng/render/image.h"

namespace throng::app {

/// Names the contents of a picture's pixels, which decide what it can be compared with.
enum class PixelKind : std::uint8_t { colours, numbers, labels, depths };
/// Returns "colours", "numbers", ...
std::string pixel_kind_name(PixelKind kind);

/// A picture to compare: colours, or a file of `--labels`. A grey picture of 16 bits that does not name its contents
/// holds numbers.
struct ComparedPicture {
  render::NumberImage image;
  PixelKind kind = PixelKind::colours;
  double metres_a_step = 0.0;  ///< of depths

  ComparedPicture(const render::Image& colours) : image(render::in_16_bits(colours)) {}
  ComparedPicture(render::NumberImage pixels, PixelKind holds) : image(std::move(pixels)), kind(holds) {}
};

/// Reads a picture and the texts in it. Errors are whole sentences.
Result<ComparedPicture> read_compared(const std::filesystem::path& file);

/// Returns the texts that name the contents of a PNG.
std::vector<render::PngText> label_texts();
std::vector<render::PngText> depth_texts(double metres_a_step);

/// Says how far two pictures of one size are apart. Of colours, a pixel is off by the mean of its channels in steps of
/// 255, or by its alpha if that is more; of depths, by metres, where nothing counts as the farthest; of labels and
/// numbers, by 1 if they differ.
struct PictureDifference {
  PixelKind kind = PixelKind::colours;
  double mean = 0.0;         ///< the mean over all pixels: light that changed everywhere and by little shows here
  double worst_block = 0.0;  ///< the largest mean of a 16x16 block: one missing hand shows here
  int worst_block_x = 0;     ///< pixels: the corner of that block
  int worst_block_y = 0;
  double share = 0.0;  ///< the share of pixels of which a channel is off by more than `seen_steps`, or a number at all

  bool is_none() const { return mean == 0.0 && share == 0.0; }
};

/// A pixel of colours counts as different if a channel of it is off by more steps of 255 than this.
inline constexpr int seen_steps = 16;

/// Measures the difference. Errors: the sizes or the contents differ; the error names both.
Result<PictureDifference> measure_difference(const ComparedPicture& expected, const ComparedPicture& actual);

/// Returns the absolute difference of two pictures of one size, eight times as bright; numbers that differ are white.
render::Image paint_difference(const ComparedPicture& expected, const ComparedPicture& actual);

/// Returns the expected picture in grey with differences in colour: from blue, a step, over yellow to red, 64 steps and
/// more. A frame is around the worst block.
render::Image paint_heat(const ComparedPicture& expected, const ComparedPicture& actual,
                         const PictureDifference& difference);

/// Returns a picture with `bits` bits a channel, 1 to 8; fewer bits compress better. White stays.
render::Image rounded_to_bits(render::Image image, int bits);
/// Rounds colours if `bits` is below 8; returns any other picture as it is.
ComparedPicture rounded_to_bits(ComparedPicture picture, int bits);

}  // namespace throng::app
