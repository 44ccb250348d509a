#include "tests/soak/gl_objects.h"

#include <initializer_list>

#include <glad/gl.h>

namespace throng::soak {
namespace {

// Names are given from 1 on, the lowest free one first or the next; far fewer are ever in use.
constexpr GLuint most_names = 20'000;

}  // namespace

std::uint64_t count_gl_objects() {
  std::uint64_t count = 0;
  for (GLuint name = 1; name <= most_names; ++name) {
    for (const bool exists :
         {glIsBuffer(name) == GL_TRUE, glIsTexture(name) == GL_TRUE, glIsFramebuffer(name) == GL_TRUE,
          glIsRenderbuffer(name) == GL_TRUE, glIsVertexArray(name) == GL_TRUE, glIsSampler(name) == GL_TRUE,
          glIsQuery(name) == GL_TRUE, glIsProgramPipeline(name) == GL_TRUE, glIsTransformFeedback(name) == GL_TRUE}) {
      count += exists ? 1 : 0;
    }
  }
  return count;
}

std::uint64_t count_gl_programs() {
  std::uint64_t count = 0;
  for (GLuint name = 1; name <= most_names; ++name) {
    count += glIsProgram(name) == GL_TRUE || glIsShader(name) == GL_TRUE ? 1U : 0U;
  }
  return count;
}

}  // namespace throng::soak
