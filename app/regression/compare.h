#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/image.h"

namespace throng::app {

/// Says what the pixels of a picture hold, which says what it can be compared with.
enum class PixelKind : std::uint8_t { colours, numbers, labels, depths };
/// Returns "colours", "numbers", ...
std::string pixel_kind_name(PixelKind kind);

/// A picture that is compared: colours, or what `--labels` writes. A grey one of 16 bits that does not say what it
/// holds is one of numbers.
struct ComparedPicture {
  render::NumberImage image;
  PixelKind kind = PixelKind::colours;
  double metres_a_step = 0.0;  ///< of depths

  ComparedPicture(const render::Image& colours) : image(render::in_16_bits(colours)) {}
  ComparedPicture(render::NumberImage pixels, PixelKind holds) : image(std::move(pixels)), kind(holds) {}
};

/// Reads a picture and what it says of itself. Errors are whole sentences.
render::Result<ComparedPicture> read_compared(const std::filesystem::path& file);

/// Returns the texts that say in a PNG what it holds.
std::vector<render::PngText> label_texts();
std::vector<render::PngText> depth_texts(double metres_a_step);

/// Says how far two pictures of one size are apart. Of colours, a pixel is off by the mean of its channels in steps of
/// 255, or by its alpha if that is more; of depths, by metres, where nothing is as far as can be said; of labels and
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

/// A pixel of colours counts as another one if a channel of it is off by more steps of 255 than these.
inline constexpr int seen_steps = 16;

/// Measures the difference. Errors: the sizes differ, or one holds other things than the other; the error says both.
render::Result<PictureDifference> measure_difference(const ComparedPicture& expected, const ComparedPicture& actual);

/// Returns the absolute difference of two pictures of one size, eight times as bright; numbers that differ are white.
render::Image paint_difference(const ComparedPicture& expected, const ComparedPicture& actual);

/// Returns the expected picture in grey with what differs in colour: from blue, a step, over yellow to red, 64 steps
/// and more. A frame is around the worst block.
render::Image paint_heat(const ComparedPicture& expected, const ComparedPicture& actual,
                         const PictureDifference& difference);

/// Returns a picture with so many bits a channel, 1 to 8, which compresses the better the fewer they are. White stays.
render::Image rounded_to_bits(render::Image image, int bits);
/// Does the same with colours of fewer than 8 bits; returns any other picture as it is.
ComparedPicture rounded_to_bits(ComparedPicture picture, int bits);

}  // namespace throng::app
