#pragma once

#include "engine/render/gl/handles.h"
#include "engine/render/shader_library.h"

namespace throng::render {

/// The paved ground at y = 0, the sky, and the haze in which they meet: one triangle over the whole picture, its rays
/// met with the plane in the fragment shader. Drawn first, without depth: nothing in the scene lies below it.
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
