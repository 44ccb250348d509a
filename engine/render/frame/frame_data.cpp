#include "engine/render/frame/frame_data.h"

#include <glm/matrix.hpp>

namespace throng::render {
namespace {

FrameUniforms frame_uniforms(const CrowdFrame& frame) {
  const CameraView& camera = frame.camera;
  const glm::mat4 axes = glm::transpose(camera.view);
  FrameUniforms uniforms{};
  uniforms.view_projection = camera.projection * camera.view;
  uniforms.camera_position = glm::vec4(camera.position, 1.0F);
  uniforms.ray_right = axes[0] / camera.projection[0][0];
  uniforms.ray_up = axes[1] / camera.projection[1][1];
  uniforms.ray_forward = -axes[2];
  uniforms.now = frame.now;
  uniforms.distance_scale = frame.distance_scale;
  return uniforms;
}

}  // namespace

void FrameData::upload(const CrowdFrame& frame) {
  const FrameUniforms uniforms = frame_uniforms(frame);
  glNamedBufferSubData(uniforms_.id(), 0, sizeof(uniforms), &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, frame_uniforms_binding, uniforms_.id());
  turn_ = (turn_ + 1) % instances_.size();
  instances_[turn_].upload(frame.instances);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, instances_binding, instances_[turn_].id());
  if (frame.morph_weights.empty()) return;
  morph_weights_[turn_].upload(frame.morph_weights);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_weights_binding, morph_weights_[turn_].id());
}

}  // namespace throng::render
