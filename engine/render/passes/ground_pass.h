#pragma once

#include "engine/render/gl/handles.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws the paved ground at y = 0, the sky, and the haze between them. One triangle covers the picture; the fragment
/// shader finds where each pixel's ray meets the ground. It writes no depth and must come first, because nothing in the
/// scene lies below the ground.
class GroundPass {
 public:
  static Result<GroundPass> create(ShaderLibrary& shaders);

  void draw() const;

 private:
  GroundPass(const ShaderLibrary& shaders, ProgramHandle program);

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
  gl::VertexArray no_vertices_;
};

}  // namespace throng::render
