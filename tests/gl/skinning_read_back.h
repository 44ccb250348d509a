#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "throng/render/renderer.h"

#include "engine/render/frame/image_target.h"
#include "engine/render/gl/handles.h"
#include "engine/render/shader/shader_library.h"

namespace throng::render::test {

/// A vertex as the crowd's vertex shader computes it.
struct ReadBackVertex {
  glm::vec3 position;  ///< metres, world space
  glm::vec3 normal;    ///< world space, not unit
};
static_assert(sizeof(ReadBackVertex) == 24);

/// Names one agent of a frame.
struct ReadBackAgent {
  std::uint32_t instance = 0;
  std::uint32_t page = 0;
  std::uint8_t character = 0;
};

/// Runs the crowd's own skinning function and captures the result, for tests that compare it with a reference.
class SkinningReadBack {
 public:
  /// `renderer` must outlive it.
  explicit SkinningReadBack(Renderer& renderer);

  /// Uploads the frame and reads every vertex of the agent's surface, in the order of CrowdMeshData's parts. Draws
  /// nothing; waits for the device.
  std::vector<ReadBackVertex> read(const CrowdFrame& frame, const ReadBackAgent& agent) const;

 private:
  Renderer* renderer_;
  ShaderLibrary shaders_;
  const gl::Program& program_;
  ImageTarget target_ = std::move(*ImageTarget::create({1, 1}, 0));
};

}  // namespace throng::render::test
