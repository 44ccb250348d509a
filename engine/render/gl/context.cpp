#include "engine/render/gl/context.h"

#include <array>
#include <string_view>

#include <glad/gl.h>

namespace throng::render::gl {
namespace {

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

bool runs_on_processor(std::string_view renderer) {
  constexpr std::array<std::string_view, 3> software_renderers = {"llvmpipe", "softpipe", "SWR"};
  for (const std::string_view name : software_renderers) {
    if (renderer.find(name) != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

Status Context::load_functions(ProcedureSource source) {
  if (gladLoadGL(source) == 0 || GLAD_GL_VERSION_4_5 == 0) {
    return Error{std::string(kind()) + " gives no OpenGL 4.5 core; a newer graphics driver is needed"};
  }
  version_ = text_of(GL_VERSION);
  renderer_ = text_of(GL_RENDERER);
  software_ = runs_on_processor(renderer_);
  collect_messages(messages_);
  return Done{};
}

}  // namespace throng::render::gl
