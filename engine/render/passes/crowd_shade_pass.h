#pragma once

#include "throng/render/crowd_draw.h"

#include "engine/render/light/shadow_uniforms.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws a map of how crowded the ground is, seen from above. Shaders tell from it how much of the sky people leave
/// each other and the ground between them. The map lies in front of the camera; beyond it nothing is dimmed.
class CrowdShadePass {
 public:
  static constexpr int map_side = 256;  ///< texels

  explicit CrowdShadePass(ShaderLibrary& shaders) : program_(shaders.load({"crowd_shade.vert", "crowd_shade.frag"})) {}

  /// Draws the map of the frame that was uploaded last, in one call. `farthest` is the depth of its last instance.
  DrawCounts draw(const CrowdFrame& frame, float farthest);

  /// Binds the map and says in `uniforms` where it lies.
  void describe(ShadowUniforms& uniforms) const;

 private:
  void place(const CrowdFrame& frame, float farthest);

  const gl::Program& program_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
  gl::Texture map_;  // without storage until the first draw
  gl::Framebuffer target_;
  glm::vec2 corner_{0.0F};
  float side_ = 1.0F;    // metres
  float spread_ = 1.0F;  // metres: the deviation of the bell that stands for a person
};

}  // namespace throng::render
