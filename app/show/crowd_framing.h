#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/render/camera.h"

namespace throng::app {

class Stage;

/// An upright box, metres.
struct FramedBox {
  glm::vec3 low{0.0F}, high{0.0F};
};

/// A part of the picture: shares of its width and height, from the top left, each 0 to 1.
struct PicturePart {
  float left = 0.0F, top = 0.0F, right = 1.0F, bottom = 1.0F;
};

inline constexpr float usual_aspect = 16.0F / 9.0F;

/// The share of the free part's width and height that stays empty at each of its edges.
inline constexpr float framing_margin = 0.05F;

/// Moves the camera, which keeps its direction, as near as all boxes, of which there is at least one, are seen in that
/// part of the picture with a margin. `aspect` is the aspect ratio of the whole picture.
render::Camera framed(const render::Camera& camera, std::span<const FramedBox> boxes, float aspect,
                      const PicturePart& part);

/// Returns a box around each agent that holds it in all poses of its clips.
std::vector<FramedBox> boxes_of(const Stage& stage);

}  // namespace throng::app
