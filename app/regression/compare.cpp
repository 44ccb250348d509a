#include "app/regression/compare.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

namespace throng::app {
namespace {

using render::Image;

constexpr int compared_channels = 3;
constexpr int block_edge = 16;

std::string size_text(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

/// Says how far one pixel is off: all channels together, and the worst of them.
struct PixelDifference {
  int sum = 0, worst = 0;
};

PixelDifference difference_at(const Image& expected, const Image& actual, int x, int y) {
  PixelDifference result;
  for (int channel = 0; channel < compared_channels; ++channel) {
    const int steps = std::abs(expected.pixel(x, y)[channel] - actual.pixel(x, y)[channel]);
    result.sum += steps;
    result.worst = std::max(result.worst, steps);
  }
  return result;
}

void paint(std::uint8_t* pixel, const std::array<int, 3>& color) {
  for (std::size_t channel = 0; channel < color.size(); ++channel) {
    pixel[channel] = static_cast<std::uint8_t>(std::clamp(color[channel], 0, 255));
  }
}

/// Between two stops the colour is mixed. A single step has to be seen on grey already.
std::array<int, 3> heat_of(int steps) {
  struct Stop {
    int steps;
    std::array<int, 3> color;
  };
  static constexpr std::array<Stop, 4> stops{
      {{1, {60, 90, 220}}, {16, {40, 200, 210}}, {32, {250, 220, 40}}, {64, {230, 30, 30}}}};
  if (steps >= stops.back().steps) return stops.back().color;
  std::size_t next = 1;
  while (stops.at(next).steps < steps) ++next;
  const Stop &from = stops.at(next - 1), &to = stops.at(next);
  std::array<int, 3> color{};
  for (std::size_t i = 0; i < color.size(); ++i) {
    color.at(i) =
        from.color.at(i) + (to.color.at(i) - from.color.at(i)) * (steps - from.steps) / (to.steps - from.steps);
  }
  return color;
}

int dimmed_grey(const std::uint8_t* pixel) { return 40 + (pixel[0] * 2 + pixel[1] * 5 + pixel[2]) / 20; }

/// A ring of white around one of magenta is seen on any picture.
void frame_block(Image& picture, int left, int top) {
  constexpr std::array<int, 3> magenta{255, 0, 255}, white{255, 255, 255};
  for (int away = 1; away <= 3; ++away) {
    const int edge = block_edge + 2 * away - 1;  // between two sides of the ring
    for (int i = 0; i <= edge; ++i) {
      const int x = left - away, y = top - away;
      for (const auto& [px, py] :
           {std::pair{x + i, y}, std::pair{x + i, y + edge}, std::pair{x, y + i}, std::pair{x + edge, y + i}}) {
        if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
        paint(picture.pixel(px, py), away == 3 ? white : magenta);
      }
    }
  }
}

}  // namespace

render::Result<PictureDifference> measure_difference(const Image& expected, const Image& actual) {
  if (expected.width != actual.width || expected.height != actual.height) {
    return render::Error{"the sizes differ: " + size_text(expected) + " expected, " + size_text(actual) + " drawn"};
  }
  PictureDifference result;
  double total = 0.0, seen = 0.0;
  for (int top = 0; top < expected.height; top += block_edge) {
    for (int left = 0; left < expected.width; left += block_edge) {
      const int bottom = std::min(top + block_edge, expected.height);
      const int right = std::min(left + block_edge, expected.width);
      int sum = 0;
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
          const PixelDifference pixel = difference_at(expected, actual, x, y);
          sum += pixel.sum;
          seen += pixel.worst > seen_steps ? 1 : 0;
        }
      }
      total += sum;
      const double block_mean = sum / static_cast<double>((bottom - top) * (right - left) * compared_channels);
      if (block_mean <= result.worst_block) continue;
      result.worst_block = block_mean;
      result.worst_block_x = left;
      result.worst_block_y = top;
    }
  }
  const double pixels = static_cast<double>(expected.width) * expected.height;
  result.mean = total / (pixels * compared_channels);
  result.share = seen / pixels;
  return result;
}

Image paint_difference(const Image& expected, const Image& actual) {
  constexpr int gain = 8;
  Image picture = Image::blank(expected.width, expected.height);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 == compared_channels) continue;
    picture.rgba[i] = static_cast<std::uint8_t>(std::min(255, gain * std::abs(expected.rgba[i] - actual.rgba[i])));
  }
  return picture;
}

Image paint_heat(const Image& expected, const Image& actual, const PictureDifference& difference) {
  Image picture = Image::blank(expected.width, expected.height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int steps = difference_at(expected, actual, x, y).worst;
      const int grey = dimmed_grey(expected.pixel(x, y));
      paint(picture.pixel(x, y), steps == 0 ? std::array<int, 3>{grey, grey, grey} : heat_of(steps));
    }
  }
  if (difference.worst_block > 0) frame_block(picture, difference.worst_block_x, difference.worst_block_y);
  return picture;
}

Image rounded_to_bits(Image image, int bits) {
  const auto kept = static_cast<std::uint8_t>(0xFFU << static_cast<unsigned>(8 - bits));
  for (std::uint8_t& value : image.rgba) {
    if (value != 255) value = static_cast<std::uint8_t>(value & kept);
  }
  return image;
}

}  // namespace throng::app
