#include "engine/render/frame/frame_uniforms.h"

#include <glm/matrix.hpp>

namespace throng::render {

FrameUniforms frame_uniforms(const CameraView& camera, std::uint32_t now) {
  const glm::mat4 axes = glm::transpose(camera.view);
  FrameUniforms uniforms{};
  uniforms.view_projection = camera.projection * camera.view;
  uniforms.camera_position = glm::vec4(camera.position, 1.0F);
  uniforms.ray_right = axes[0] / camera.projection[0][0];
  uniforms.ray_up = axes[1] / camera.projection[1][1];
  uniforms.ray_forward = -axes[2];
  uniforms.now = now;
  return uniforms;
}

}  // namespace throng::render
