#include "throng/render/context.h"

#include <algorithm>
#include <new>

#include <glad/gl.h>

#include "engine/render/gl/device_errors.h"
#include "engine/render/gl/device_limits.h"

namespace throng::render::gl {
namespace {

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

bool runs_on_processor(const std::string& renderer) {
  return std::ranges::any_of(std::initializer_list<const char*>{"llvmpipe", "softpipe", "SWR"},
                             [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

void on_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void* log) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  const_cast<MessageLog*>(static_cast<const MessageLog*>(log))->add({text, static_cast<std::size_t>(length)});
}

}  // namespace

void MessageLog::add(std::string_view message) noexcept {
  const std::lock_guard lock(mutex_);
  ++count_;
  try {
    if (messages_.size() < kept_messages) messages_.emplace_back(message);
  } catch (const std::bad_alloc&) {
    return;  // it is counted, and the driver that calls holds locks of its own
  }
}

std::vector<std::string> MessageLog::messages() const {
  const std::lock_guard lock(mutex_);
  return messages_;
}

std::size_t MessageLog::count() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

void MessageLog::clear() {
  const std::lock_guard lock(mutex_);
  messages_.clear();
  count_ = 0;
}

Status Context::load_functions(ProcedureSource source) {
  if (gladLoadGL(source) == 0 || GLAD_GL_VERSION_4_5 == 0) {
    return Error{std::string(kind()) + " gives no OpenGL 4.5 core context"};
  }
  version_ = text_of(GL_VERSION);
  renderer_ = text_of(GL_RENDERER);
  software_ = runs_on_processor(renderer_);
  limits_ = ask_device_limits();
  (void)take_errors("what the driver did before us");
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, &messages_);
  return Done{};
}

}  // namespace throng::render::gl
