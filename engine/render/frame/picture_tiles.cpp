#include "engine/render/frame/picture_tiles.h"

#include <algorithm>
#include <cassert>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include "engine/base/text/size_text.h"

namespace throng::render {
namespace {

constexpr std::uint64_t bytes_a_finished_pixel = 4;
constexpr int shortest_side = 256;  // pixels; smaller tiles would save no memory worth the draws

int parts_of(int length, int longest) { return (length + longest - 1) / longest; }

// All parts are equally long and even, but for a length of one part.
int length_of_parts(int length, int parts) { return parts == 1 ? length : (parts_of(length, parts) + 1) / 2 * 2; }

std::uint64_t pixels_of(glm::ivec2 size) {
  return static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
}

std::uint64_t bytes_for(const PictureTiles& tiles, const TileLimits& limits) {
  return pixels_of(tiles.picture()) * (bytes_a_finished_pixel + limits.bytes_beside) +
         pixels_of(tiles.tile_size()) * limits.bytes_a_pixel;
}

/// Finds tiles as large as fit, from the longest sides on.
PictureTiles tiles_that_fit(glm::ivec2 picture, const TileLimits& limits) {
  if (limits.whole) return {picture, glm::max(picture, glm::ivec2(2))};
  PictureTiles tiles(picture, limits.longest);
  glm::ivec2 longest = tiles.tile_size();
  while (bytes_for(tiles, limits) > limits.memory && std::max(longest.x, longest.y) > shortest_side) {
    longest = glm::max(longest / 2, glm::min(longest, glm::ivec2(shortest_side)));
    longest = glm::max(longest, glm::ivec2(2));
    tiles = PictureTiles(picture, longest);
  }
  return tiles;
}

/// Finds the largest picture of a shape that fits, by halving the range of its sizes.
glm::ivec2 largest_that_fits(glm::ivec2 shape, const TileLimits& limits) {
  double fits = 0.0, too_large = 1.0;
  const auto scaled = [&](double scale) { return glm::max(glm::ivec2(glm::dvec2(shape) * scale), glm::ivec2(1)); };
  for (int step = 0; step < 32; ++step) {
    const double middle = (fits + too_large) / 2.0;
    const PictureTiles tiles = tiles_that_fit(scaled(middle), limits);
    (bytes_for(tiles, limits) <= limits.memory ? fits : too_large) = middle;
  }
  return scaled(fits);
}

}  // namespace

PictureTiles::PictureTiles(glm::ivec2 picture, glm::ivec2 longest) : picture_(picture) {
  assert(picture.x > 0 && picture.y > 0 && longest.x > 1 && longest.y > 1);
  const glm::ivec2 even = longest / 2 * 2;
  columns_ = picture.x <= longest.x ? 1 : parts_of(picture.x, even.x);
  rows_ = picture.y <= longest.y ? 1 : parts_of(picture.y, even.y);
  tile_size_ = {length_of_parts(picture.x, columns_), length_of_parts(picture.y, rows_)};
}

PixelRect PictureTiles::drawn(int tile) const {
  assert(tile >= 0 && tile < count());
  return {glm::ivec2(tile % columns_, tile / columns_) * tile_size_, tile_size_};
}

PixelRect PictureTiles::shown(int tile) const {
  const PixelRect whole = drawn(tile);
  return {whole.corner, glm::min(whole.size, picture_ - whole.corner)};
}

CameraView part_of(const CameraView& view, glm::ivec2 picture, const PixelRect& drawn) {
  const glm::dvec2 whole(picture), size(drawn.size), corner(drawn.corner);
  const glm::vec2 scale(whole / size);
  const glm::vec2 offset((whole - 2.0 * corner - size) / size);
  glm::mat4 to_part(1.0F);
  to_part[0][0] = scale.x;
  to_part[1][1] = scale.y;
  to_part[3][0] = offset.x;
  to_part[3][1] = offset.y;
  CameraView part = view;
  part.projection = to_part * view.projection;
  return part;
}

SplitView part_of(const SplitView& split, glm::ivec2 picture, const PixelRect& drawn) {
  SplitView part = split;
  part.divider = (split.divider * static_cast<float>(picture.x) - static_cast<float>(drawn.corner.x)) /
                 static_cast<float>(drawn.size.x);
  return part;
}

std::string size_name(glm::ivec2 size) { return std::to_string(size.x) + "x" + std::to_string(size.y); }

Result<PictureTiles> plan_tiles(glm::ivec2 picture, const TileLimits& limits) {
  const PictureTiles tiles = tiles_that_fit(picture, limits);
  const std::uint64_t bytes = bytes_for(tiles, limits);
  if (bytes <= limits.memory) return tiles;
  return Error{"a picture of " + size_name(picture) + " pixels takes " + size_text(bytes) + " of memory, and " +
               size_text(limits.memory) + " are left; the largest of its shape is " +
               size_name(largest_that_fits(picture, limits))};
}

}  // namespace throng::render
