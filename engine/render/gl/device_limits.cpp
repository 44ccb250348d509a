#include "engine/render/gl/device_limits.h"

#include <algorithm>

#include <glad/gl.h>
#include <glm/common.hpp>

namespace throng::render::gl {
namespace {

int number_of(GLenum name) {
  GLint number = 0;
  glGetIntegerv(name, &number);
  return number;
}

}  // namespace

DeviceLimits ask_device_limits() {
  DeviceLimits limits;
  limits.texture = number_of(GL_MAX_TEXTURE_SIZE);
  GLint viewport[2] = {0, 0};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  const int side = std::min(limits.texture, number_of(GL_MAX_RENDERBUFFER_SIZE));
  limits.target = glm::min(glm::ivec2(viewport[0], viewport[1]), glm::ivec2(side));
  limits.samples = std::min(
      {number_of(GL_MAX_SAMPLES), number_of(GL_MAX_COLOR_TEXTURE_SAMPLES), number_of(GL_MAX_DEPTH_TEXTURE_SAMPLES)});
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  limits.storage_block = static_cast<std::size_t>(bytes);
  return limits;
}

}  // namespace throng::render::gl
