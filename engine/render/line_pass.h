#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "engine/render/crowd_draw.h"
#include "engine/render/gl/handles.h"
#include "engine/render/shader_library.h"

namespace throng::render {

/// Straight lines in the world, of an even width on the screen: what explains the scene, such as another camera's
/// frustum. Drawn over the crowd; what lies behind somebody shows through, faintly.
class LinePass {
 public:
  static Result<LinePass> create(ShaderLibrary& shaders);

  /// `picture`: pixels of what is drawn into.
  DrawCounts draw(std::span<const SceneLine> lines, glm::ivec2 picture);

 private:
  LinePass(const ShaderLibrary& shaders, ProgramHandle program);

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
  gl::VertexArray vertex_array_;
  gl::Buffer lines_;
};

}  // namespace throng::render
