#include "engine/render/frame/tiled_target.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace throng::render {
namespace {

constexpr int shortest_tile = 64;  // pixels; a device that refuses such a small one refuses all

Error too_large(glm::ivec2 size, glm::ivec2 longest) {
  return Error{"a picture of " + size_name(size) +
               " pixels is larger than the graphics device takes: " + size_name(longest)};
}

}  // namespace

TiledTarget::TiledTarget(ImageTarget target, const PictureTiles& tiles) : target_(std::move(target)), tiles_(tiles) {
  if (is_tiled()) image_ = Image::blank(size().x, size().y);
}

Result<TiledTarget> TiledTarget::create(glm::ivec2 size, int samples, const TileLimits& limits) {
  if (limits.whole && (size.x > limits.longest.x || size.y > limits.longest.y)) return too_large(size, limits.longest);
  TileLimits tried = limits;
  while (true) {
    const Result<PictureTiles> tiles = plan_tiles(size, tried);
    if (!tiles) return tiles.error();
    Result<ImageTarget> target = ImageTarget::create(tiles->tile_size(), samples);
    if (target) return TiledTarget(std::move(*target), *tiles);
    const glm::ivec2 tile = tiles->tile_size();
    if (limits.whole || std::max(tile.x, tile.y) <= shortest_tile) return target.error();
    tried.longest = glm::max(glm::min(tile, tried.longest) / 2, glm::ivec2(2));
  }
}

const Image& TiledTarget::read() {
  if (is_tiled()) return image_;
  if (image_.rgba.empty()) image_ = Image::blank(size().x, size().y);
  target_.read(image_, {{0, 0}, size()});
  return image_;
}

void TiledTarget::write(const Image& image) {
  if (is_tiled()) {
    image_ = image;
  } else {
    target_.write(image, {{0, 0}, size()});
  }
}

}  // namespace throng::render
