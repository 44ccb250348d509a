#include "engine/render/frame/frame_data.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <vector>

#include <glm/matrix.hpp>

namespace throng::render {
namespace {

FrameUniforms frame_uniforms(const CrowdFrame& frame) {
  const CameraView& camera = frame.camera;
  const glm::mat4& projection = camera.projection;
  const glm::mat4 axes = glm::transpose(camera.view);
  FrameUniforms uniforms{};
  uniforms.view_projection = camera.projection * camera.view;
  uniforms.camera_position = glm::vec4(camera.position, 1.0F);
  uniforms.ray_right = axes[0] / projection[0][0];
  uniforms.ray_up = axes[1] / projection[1][1];
  // The middle of a tile is off the axis of the camera.
  uniforms.ray_forward = uniforms.ray_right * projection[2][0] + uniforms.ray_up * projection[2][1] - axes[2];
  uniforms.now = frame.now;
  uniforms.distance_scale = frame.distance_scale;
  uniforms.weighed_entry = frame.weighed.first;
  uniforms.weighed_entries = frame.weighed.count;
  const SceneGround& ground = frame.ground;
  uniforms.ground_shape = glm::vec4(ground.core, ground.radius, ground.half_width);
  uniforms.ground_is_endless = ground.paved == 0.0F ? 1U : 0U;
  uniforms.ground_unit = ground.unit;
  return uniforms;
}

}  // namespace

void FrameData::upload_view(const CrowdFrame& frame) {
  const FrameUniforms uniforms = frame_uniforms(frame);
  glNamedBufferSubData(uniforms_.id(), 0, sizeof(uniforms), &uniforms);
}

void FrameData::upload_looks(const CrowdFrame& frame) {
  if (frame.looks.empty()) {
    upload_plain_looks(frame.instances);
  } else if (frame.looks_number != looks_number_) {
    assert(frame.looks_number != 0);
    looks_.upload(frame.looks);
    looks_number_ = frame.looks_number;
    plain_looks_ = 0;
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, looks_binding, looks_.id());
}

void FrameData::upload_plain_looks(std::span<const InstanceRecord> instances) {
  std::size_t needed = 0;
  for (const InstanceRecord& record : instances) needed = std::max<std::size_t>(needed, record.agent + 1U);
  if (needed <= plain_looks_) return;
  plain_looks_ = std::bit_ceil(needed);
  looks_.upload(std::vector<AgentLook>(plain_looks_, plain_look()));
  looks_number_ = 0;
}

void FrameData::upload_drawn(const CrowdFrame& frame) {
  draws_lists_ = !frame.drawn.empty();
  if (draws_lists_) {
    drawn_[turn_].upload(frame.drawn);
  } else if (frame.instances.size() >= counted_) {
    counted_ = std::bit_ceil(frame.instances.size() + 1);
    std::vector<std::uint32_t> numbers(counted_);
    std::iota(numbers.begin(), numbers.end(), 0U);
    all_.upload(numbers);
  }
  bind_drawn();
}

void FrameData::bind_drawn() const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, drawn_binding, draws_lists_ ? drawn_[turn_].id() : all_.id());
}

void FrameData::upload(const CrowdFrame& frame) {
  upload_view(frame);
  upload_looks(frame);
  glBindBufferBase(GL_UNIFORM_BUFFER, frame_uniforms_binding, uniforms_.id());
  turn_ = (turn_ + 1) % instances_.size();
  instances_[turn_].upload(frame.instances);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, instances_binding, instances_[turn_].id());
  upload_drawn(frame);
  if (frame.morph_weights.empty()) return;
  morph_weights_[turn_].upload(frame.morph_weights);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_weights_binding, morph_weights_[turn_].id());
}

}  // namespace throng::render
