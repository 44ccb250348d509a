#include "engine/render/passes/crowd_shade_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/render/frame/frame_data.h"

namespace throng::render {
namespace {

constexpr GLint map_location = 0, spread_location = 1;
constexpr GLsizei corners_of_a_square = 4;
constexpr float least_side = 96.0F;     // metres
constexpr float least_spread = 0.8F;    // metres: a farther agent leaves most of the sky
constexpr float share_in_front = 0.4F;  // of the side: how far before the camera the middle lies

gl::Texture create_map() {
  gl::Texture map = gl::create_texture(GL_R16F, CrowdShadePass::map_side, CrowdShadePass::map_side);
  glTextureParameteri(map.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(map.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTextureParameteri(map.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  return map;
}

}  // namespace

// The map is as large as a power of two of metres, and moves in whole texels, so that shade does not crawl.
void CrowdShadePass::place(const CrowdFrame& frame, float farthest) {
  side_ = std::max(least_side, std::exp2(std::ceil(std::log2(1.2F * farthest))));
  const float texel = side_ / map_side;
  spread_ = std::max(least_spread, texel);
  const glm::mat4& view = frame.camera.view;
  const glm::vec2 ahead(-view[0][2], -view[2][2]);
  const float level = glm::length(ahead);
  const glm::vec2 middle = glm::vec2(frame.camera.position.x, frame.camera.position.z) +
                           (level > 1e-3F ? ahead * (share_in_front * side_ / std::max(level, 0.3F)) : ahead);
  corner_ = glm::floor((middle - 0.5F * side_) / texel) * texel;
}

DrawCounts CrowdShadePass::draw(const CrowdFrame& frame, float farthest) {
  if (!map_) {
    map_ = create_map();
    target_ = gl::create_framebuffer();
    glNamedFramebufferTexture(target_.id(), GL_COLOR_ATTACHMENT0, map_.id(), 0);
  }
  place(frame, farthest);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  constexpr GLfloat no_agent[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  glClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, no_agent);
  if (frame.instances.empty()) return {};
  glViewport(0, 0, map_side, map_side);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glUseProgram(program_.id());
  glUniform3f(map_location, corner_.x, corner_.y, 1.0F / side_);
  glUniform1f(spread_location, spread_);
  glBindVertexArray(no_vertices_.id());
  const auto count = static_cast<GLsizei>(frame.instances.size());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners_of_a_square, count);
  glDisable(GL_BLEND);
  return {1, std::uint64_t{2} * frame.instances.size()};
}

void CrowdShadePass::describe(ShadowUniforms& uniforms) const {
  const float own = 1.0F / (2.0F * std::numbers::pi_v<float> * spread_ * spread_);
  uniforms.crowd_map = {corner_, 1.0F / side_, own};
  glBindTextureUnit(crowd_map_unit, map_.id());
}

}  // namespace throng::render
