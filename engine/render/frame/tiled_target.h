#pragma once

#include <glm/vec2.hpp>

#include "throng/render/image.h"

#include "engine/base/result.h"
#include "engine/render/frame/image_target.h"
#include "engine/render/frame/picture_tiles.h"

namespace throng::render {

/// Receives pictures of any size. A picture that is larger than any target is drawn in tiles, one after the other into
/// the same target, and put together in memory.
class TiledTarget {
 public:
  /// Makes a target for pictures of `size`. If the device has no memory for the largest tiles of `limits`, it gets
  /// smaller ones, unless there may be only one. Errors: memory or the device take no such picture.
  static Result<TiledTarget> create(glm::ivec2 size, int samples, const TileLimits& limits);

  glm::ivec2 size() const { return tiles_.picture(); }
  const PictureTiles& tiles() const { return tiles_; }
  bool is_tiled() const { return tiles_.count() > 1; }

  /// Returns the target that each tile is drawn into. It holds the whole picture if that is not tiled.
  const ImageTarget& tile() const { return target_; }

  /// Calls `draw` with the pixels of each tile in turn, and keeps the pixels of tile().
  void draw_tiles(const auto& draw) {
    for (int tile = 0; tile < tiles_.count(); ++tile) {
      draw(tiles_.drawn(tile));
      if (is_tiled()) target_.read(image_, tiles_.shown(tile));
    }
  }

  /// Draws tiles over the finished pixels of the last picture.
  void draw_tiles_over(const auto& draw) {
    for (int tile = 0; tile < tiles_.count(); ++tile) {
      if (is_tiled()) target_.write(image_, tiles_.shown(tile));
      draw(tiles_.drawn(tile));
      if (is_tiled()) target_.read(image_, tiles_.shown(tile));
    }
  }

  /// Reads the last picture. The image is valid until the next one is drawn.
  const Image& read();
  /// Makes the last picture that image, which is as large.
  void write(const Image& image);

 private:
  TiledTarget(ImageTarget target, const PictureTiles& tiles);

  ImageTarget target_;
  PictureTiles tiles_;
  Image image_;  // of the whole; empty until it is needed
};

}  // namespace throng::render
