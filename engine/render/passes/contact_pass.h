#pragma once

#include <cstdint>

#include "engine/render/crowd_draw.h"
#include "engine/render/gl/handles.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// Draws a soft dark spot below every agent, in one call, so that agents seem to stand on the ground.
/// Frame uniforms and instances must be bound. Call it after the ground and before the crowd.
class ContactPass {
 public:
  static Result<ContactPass> create(ShaderLibrary& shaders);

  /// `with_sun_side` adds a soft streak away from the sun, in place of a cast shadow.
  DrawCounts draw(std::uint32_t instance_count, bool with_sun_side) const;

 private:
  ContactPass(const ShaderLibrary& shaders, ProgramHandle program);

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
  gl::VertexArray no_vertices_;
};

}  // namespace throng::render
