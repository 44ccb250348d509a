#include <utility>

#include <glad/gl.h>

#include "tests/faulty_program/faults.h"

namespace throng::test {
namespace {

GLenum kept_error = GL_NO_ERROR;  // the context has one thread

/// Stands in place of a function of GL: it fails as for want of memory, or calls the real one.
template <auto& Function>
struct Wrapped;

template <typename Answer, typename... Arguments, Answer (*&Function)(Arguments...)>
struct Wrapped<Function> {
  static inline Answer (*real)(Arguments...) = nullptr;

  static Answer call(Arguments... arguments) {
    if (!must_fail(Call::gl)) return real(arguments...);
    kept_error = GL_OUT_OF_MEMORY;
    return Answer();
  }

  static void install() {
    if (Function == nullptr || Function == &call) return;
    real = Function;
    Function = &call;
  }
};

GLenum (*real_get_error)() = nullptr;

GLenum get_error() {
  const GLenum kept = kept_error;
  kept_error = GL_NO_ERROR;
  return kept != GL_NO_ERROR ? kept : real_get_error();
}

}  // namespace

void wrap_gl_functions() {
  Wrapped<glad_glNamedBufferStorage>::install();
  Wrapped<glad_glNamedBufferData>::install();
  Wrapped<glad_glMapNamedBufferRange>::install();
  Wrapped<glad_glTextureStorage2D>::install();
  Wrapped<glad_glTextureStorage2DMultisample>::install();
  Wrapped<glad_glNamedRenderbufferStorageMultisample>::install();
  Wrapped<glad_glCreateShader>::install();
  Wrapped<glad_glCreateProgram>::install();
  Wrapped<glad_glCompileShader>::install();
  Wrapped<glad_glLinkProgram>::install();
  Wrapped<glad_glFenceSync>::install();
  Wrapped<glad_glCheckNamedFramebufferStatus>::install();
  Wrapped<glad_glMultiDrawElementsIndirect>::install();
  Wrapped<glad_glDrawElements>::install();
  Wrapped<glad_glDrawArrays>::install();
  Wrapped<glad_glReadPixels>::install();
  Wrapped<glad_glBlitNamedFramebuffer>::install();
  if (glad_glGetError != get_error) real_get_error = std::exchange(glad_glGetError, get_error);
}

}  // namespace throng::test
