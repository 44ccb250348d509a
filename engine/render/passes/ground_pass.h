#pragma once

#include <cstdint>

#include "engine/render/crowd_draw.h"
#include "engine/render/shader/program_variants.h"

namespace throng::render {

/// Draws the paved ground at y = 0, the sky and the haze between them, and a soft dark spot below every agent, so that
/// agents seem to stand on the ground.
class GroundPass {
 public:
  explicit GroundPass(ShaderLibrary& shaders);

  /// Covers the picture with one triangle; the fragment shader finds where each pixel's ray meets the ground. It fills
  /// what nothing opaque was drawn into and writes no depth, because nothing in the scene lies below the ground. Frame
  /// data must be bound.
  /// `light` has the parts of the light (light_parts.h).
  DrawCounts draw(GroundStyle style, std::uint32_t light);

  /// Draws the spots in one call, after the ground and the crowd. `with_sun_side` adds a soft streak away from
  /// the sun to each, in place of a cast shadow. Frame data must be bound.
  DrawCounts draw_spots(std::uint32_t instance_count, bool with_sun_side) const;

 private:
  ProgramVariants ground_;
  const gl::Program& spots_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
};

}  // namespace throng::render
