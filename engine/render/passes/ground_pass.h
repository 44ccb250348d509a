#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/shader/program_variants.h"

namespace throng::render {

/// Draws the paved ground at y = 0, the sky and the haze between them, and a soft dark spot below every agent, so that
/// agents seem to stand on the ground.
class GroundPass {
 public:
  explicit GroundPass(ShaderLibrary& shaders);

  /// Draws ground and sky where nothing has been drawn, into a target of so many pixels. Each pixel is computed once:
  /// the town's ground, the fields around it and the sky have a program each. The ground is deep behind all that
  /// stands. Frame data and light must be bound. `light` has the parts of the light (light_parts.h).
  DrawCounts draw(const SceneGround& ground, glm::ivec2 pixels, std::uint32_t light);

  /// Draws the spots in one call, after the ground and before the crowd. `with_sun_side` adds a soft streak away from
  /// the sun to each, in place of a cast shadow. Frame data must be bound.
  DrawCounts draw_spots(std::uint32_t instance_count, bool with_sun_side) const;

 private:
  DrawCounts draw_part(std::uint32_t switches, const SceneGround& ground, glm::ivec2 pixels, bool to_horizon);

  ProgramVariants ground_;
  const gl::Program& sky_;
  const gl::Program& spots_;
  gl::VertexArray no_vertices_ = gl::create_vertex_array();
};

}  // namespace throng::render
