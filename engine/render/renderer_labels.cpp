// The part of the renderer that labels pixels with agents.
#include <algorithm>
#include <limits>

#include <glm/matrix.hpp>

#include "engine/render/renderer_parts.h"

namespace throng::render {
namespace {

/// Says how far away the ground is at each pixel of a picture, along the camera's axis.
class GroundDepth {
 public:
  GroundDepth(const CameraView& view, glm::ivec2 size) : height_(view.position.y) {
    const glm::mat4 axes = glm::transpose(view.view);
    const float half_width = 1.0F / view.projection[0][0], half_height = 1.0F / view.projection[1][1];
    const glm::vec2 step(2.0F / static_cast<float>(size.x), 2.0F / static_cast<float>(size.y));
    along_x_ = axes[0].y * half_width * step.x;
    along_y_ = -axes[1].y * half_height * step.y;
    first_ = -axes[2].y - axes[0].y * half_width + axes[1].y * half_height + 0.5F * (along_x_ + along_y_);
  }

  float at(int x, int y) const {
    const float drop = -(first_ + along_x_ * static_cast<float>(x) + along_y_ * static_cast<float>(y));
    return drop > 0.0F && height_ > 0.0F ? height_ / drop : std::numeric_limits<float>::infinity();
  }

 private:
  float height_;
  float first_ = 0.0F;  // how far the ray of the first pixel rises a metre ahead
  float along_x_ = 0.0F, along_y_ = 0.0F;
};

/// Turns depths of the device into metres. Whatever stands hides the ground.
void to_metres(const CameraView& view, LabelPicture& labels) {
  const GroundDepth ground(view, labels.size);
  const glm::mat4& projection = view.projection;
  for (int y = 0; y < labels.size.y; ++y) {
    for (int x = 0; x < labels.size.x; ++x) {
      float& depth = labels.metres[labels.place(x, y)];
      depth = depth > 0.0F ? projection[3][2] / (depth + projection[2][2]) : ground.at(x, y);
    }
  }
}

}  // namespace

Status Renderer::Parts::prepare_labels() {
  if (!labels) labels.emplace(shaders);
  if (std::ranges::any_of(meshes, &CrowdMesh::has_morphs)) labels->prepare_morphs();
  if (!shaders.status()) return shaders.status();
  return labels->prepare(target.tiles().tile_size());
}

Status Renderer::Parts::draw_labels(const CrowdFrame& frame, LabelPicture& picture) {
  if (Status prepared = prepare_labels(); !prepared) return prepared;
  const auto pixels = static_cast<std::size_t>(target.size().x) * static_cast<std::size_t>(target.size().y);
  picture.size = target.size();
  picture.agents.resize(pixels);
  picture.metres.resize(pixels);
  const PictureTiles& tiles = target.tiles();
  for (int tile = 0; tile < tiles.count(); ++tile) {
    CrowdFrame seen = frame;
    seen.camera = part_of(frame.camera, target.size(), tiles.drawn(tile));
    frame_data.upload_view(seen);
    labels->begin();
    const float height = static_cast<float>(tiles.tile_size().y) / frame.scenery_error_px;
    if (frame.scenery) scenery.draw_depth_in_view(seen.camera, height);
    labels->draw(seen, meshes, palettes);
    const PixelRect shown = tiles.shown(tile);
    labels->read(picture, {shown.corner.x, target.size().y - shown.corner.y - shown.size.y}, shown.size);
  }
  to_metres(frame.camera, picture);
  if (!shaders.status()) trouble = shaders.status().error();
  return finish();
}

Status Renderer::Parts::measure_bodies(const CrowdFrame& frame, std::span<const PixelBox> boxes,
                                       std::span<BodyAlone> bodies) {
  if (Status prepared = prepare_labels(); !prepared) return prepared;
  frame_data.upload_view(frame);
  if (Status measured = labels->measure(frame, meshes, palettes, target.size(), boxes, bodies); !measured)
    return measured;
  if (!shaders.status()) trouble = shaders.status().error();
  return finish();
}

}  // namespace throng::render
