#include "tests/render/image_difference.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace throng::render::test {
namespace {

constexpr int compared_channels = 3;
constexpr int block_edge = 16;
constexpr int picture_gain = 8;

std::string size_text(const Image& image) { return std::to_string(image.width) + "x" + std::to_string(image.height); }

/// Sums the absolute differences of one pixel's channels and paints them into `picture`.
int compare_pixel(const Image& expected, const Image& actual, int x, int y, Image& picture) {
  int sum = 0;
  for (int channel = 0; channel < compared_channels; ++channel) {
    const int difference = std::abs(expected.pixel(x, y)[channel] - actual.pixel(x, y)[channel]);
    picture.pixel(x, y)[channel] = static_cast<std::uint8_t>(std::min(255, difference * picture_gain));
    sum += difference;
  }
  return sum;
}

}  // namespace

Result<ImageDifference> compare(const Image& expected, const Image& actual) {
  if (expected.width != actual.width || expected.height != actual.height) {
    return Error{"images differ in size: " + size_text(expected) + " expected, " + size_text(actual) + " drawn"};
  }
  ImageDifference result;
  result.picture = Image::blank(expected.width, expected.height);
  double total = 0.0;
  for (int top = 0; top < expected.height; top += block_edge) {
    for (int left = 0; left < expected.width; left += block_edge) {
      const int bottom = std::min(top + block_edge, expected.height);
      const int right = std::min(left + block_edge, expected.width);
      int sum = 0;
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) sum += compare_pixel(expected, actual, x, y, result.picture);
      }
      total += sum;
      const double block_mean = sum / static_cast<double>((bottom - top) * (right - left) * compared_channels);
      if (block_mean <= result.worst_block) continue;
      result.worst_block = block_mean;
      result.worst_block_x = left;
      result.worst_block_y = top;
    }
  }
  result.mean = total / (static_cast<double>(expected.width) * expected.height * compared_channels);
  return result;
}

}  // namespace throng::render::test
