#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/render/mesh/mesh.h"
#include "engine/render/palette/palette_buffer.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render {

/// A vertex as the crowd's vertex shader computes it.
struct ReadBackVertex {
  glm::vec3 position;  ///< metres, world space
  glm::vec3 normal;    ///< world space, not unit
};

/// Names one agent of the bound instances.
struct ReadBackAgent {
  std::uint32_t instance = 0;
  std::uint32_t page = 0;
  std::uint8_t character = 0;
};

/// Runs the crowd's own skinning function and captures the result, for tests that compare it with a reference. Waits
/// for the device.
class SkinningReadBack {
 public:
  static Result<SkinningReadBack> create(ShaderLibrary& shaders);

  /// Reads every vertex of the surface, in the order of CrowdMeshData's parts. Frame uniforms and instances must be
  /// bound.
  std::vector<ReadBackVertex> read(const ReadBackAgent& agent, const CrowdMesh& mesh,
                                   const PaletteBuffer& palettes) const;

 private:
  SkinningReadBack(const ShaderLibrary& shaders, ProgramHandle program) : shaders_(&shaders), program_(program) {}

  const ShaderLibrary* shaders_;
  ProgramHandle program_;
};

}  // namespace throng::render
