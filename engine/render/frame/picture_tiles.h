#pragma once

#include <cstdint>
#include <string>

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"
#include "throng/render/pixel_rect.h"

#include "engine/base/result.h"

namespace throng::render {

/// Cuts a picture into tiles of one size, row by row from the bottom left. Tiles at the top and at the right may reach
/// beyond the picture. Corners are even, because a device shades 2x2 pixels together, which must stay together.
class PictureTiles {
 public:
  PictureTiles() = default;
  /// Makes the fewest tiles whose sides are no longer than `longest`, which is 2 or more.
  PictureTiles(glm::ivec2 picture, glm::ivec2 longest);

  glm::ivec2 picture() const { return picture_; }
  glm::ivec2 tile_size() const { return tile_size_; }
  int count() const { return columns_ * rows_; }

  /// Gives the pixels that a tile draws, and its pixels that are in the picture.
  PixelRect drawn(int tile) const;
  PixelRect shown(int tile) const;

 private:
  glm::ivec2 picture_{0};
  glm::ivec2 tile_size_{0};
  int columns_ = 0, rows_ = 0;
};

/// Gives the view whose picture is the part `drawn` of the picture of `view`, which has the size `picture`.
CameraView part_of(const CameraView& view, glm::ivec2 picture, const PixelRect& drawn);

/// Gives the split view whose picture is that part of a split picture.
SplitView part_of(const SplitView& split, glm::ivec2 picture, const PixelRect& drawn);

/// Returns "1280x720".
std::string size_name(glm::ivec2 size);

/// The limits of a picture.
struct TileLimits {
  glm::ivec2 longest{0};            ///< pixels of the sides of a tile
  std::uint64_t memory = 0;         ///< bytes that the machine has left
  std::uint64_t bytes_a_pixel = 0;  ///< of a tile, in the machine's memory; 0: it is in the device's own
  std::uint64_t bytes_beside = 0;   ///< a pixel of the picture, beside its colour
  bool whole = false;               ///< there is one tile, as a window needs, however long its sides are
};

/// Cuts a picture into tiles that fit into memory beside it. Errors: the picture does not fit; the error names the
/// largest one of its shape that does.
Result<PictureTiles> plan_tiles(glm::ivec2 picture, const TileLimits& limits);

}  // namespace throng::render
