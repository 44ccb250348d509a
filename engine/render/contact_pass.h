#pragma once

#include <cstdint>

#include "engine/render/crowd_draw.h"
#include "engine/render/gl/handles.h"
#include "engine/render/shader_library.h"

namespace throng::render {

/// A soft dark spot below every agent, drawn out away from the sun where no real shadow is cast, which makes agents
/// stand on the ground: one draw for all. Frame uniforms and instances must be bound; drawn between ground and crowd.
class ContactPass {
 public:
  static Result<ContactPass> create(ShaderLibrary& shaders);

  /// `with_sun_side`: also the soft streak that stands in for a cast shadow.
  DrawCounts draw(std::uint32_t instance_count, bool with_sun_side) const;

 private:
  ContactPass(const ShaderLibrary& shaders, ProgramHandle program);

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
  gl::VertexArray no_vertices_;
};

}  // namespace throng::render
