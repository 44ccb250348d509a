#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws lines that explain the scene, such as another camera's frustum. They are straight in the world, equally wide
/// everywhere on the screen, and lie over the crowd; parts behind an agent may show through faintly.
class LinePass {
 public:
  explicit LinePass(ShaderLibrary& shaders);

  /// Draws the lines. `picture` is the size of the target, in pixels.
  DrawCounts draw(std::span<const SceneLine> lines, glm::ivec2 picture, bool show_through);

 private:
  const gl::Program& program_;
  gl::Buffer lines_;
  gl::VertexArray vertex_array_;
};

}  // namespace throng::render
