#include "engine/render/gl/device_errors.h"

#include <cstdio>

namespace throng::render::gl {
namespace {

// A context that is lost may repeat its error for ever.
constexpr int most_errors = 16;

std::string with_code(const char* text, GLenum code) {
  char line[96];
  std::snprintf(line, sizeof(line), "%s (0x%04X)", text, static_cast<unsigned>(code));
  return line;
}

std::string words_for(GLenum error, const std::string& what) {
  switch (error) {
    case GL_OUT_OF_MEMORY:
      return "the graphics device has too little memory for " + what;
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "the graphics device cannot draw into the target of " + what;
    case GL_CONTEXT_LOST:
      return "the graphics device was reset during " + what;
    default:
      return "the graphics device refuses a call for " + what + with_code("", error);
  }
}

}  // namespace

Status take_errors(const std::string& what) {
  const GLenum first = glGetError();
  if (first == GL_NO_ERROR) return Done{};
  for (int more = 1; more < most_errors && glGetError() != GL_NO_ERROR; ++more) continue;
  return Error{words_for(first, what)};
}

Status check_complete(GLuint framebuffer, const std::string& what) {
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return Done{};
  return Error{"the graphics device cannot draw into the target of " + what + with_code("", status)};
}

}  // namespace throng::render::gl
