#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws the bones of all agents over the crowd. A body does not hide its own bones; behind another one they show
/// through faintly. It draws twice for each page of a character, however many agents there are.
class BonePass {
 public:
  explicit BonePass(ShaderLibrary& shaders)
      : program_(shaders.load({.vertex = "bones.vert", .fragment = "bones.frag", .geometry = "bones.geom"})) {}

  /// Draws the bones. The crowd must be drawn and frame data bound. `picture` is the size of the target, in pixels.
  DrawCounts draw(const CrowdFrame& frame, std::span<const CrowdMesh> meshes, const PaletteBuffer& palettes,
                  glm::ivec2 picture) const;

 private:
  const gl::Program& program_;
};

}  // namespace throng::render
