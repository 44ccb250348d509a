#include "engine/render/gl/message_log.h"

#include <utility>

#include <glad/gl.h>

namespace throng::render::gl {
namespace {

void on_message(GLenum, GLenum, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void* log) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  const std::string message(text, static_cast<std::size_t>(length));
  const_cast<MessageLog*>(static_cast<const MessageLog*>(log))->add(message);
}

}  // namespace

void MessageLog::add(std::string message) {
  const std::lock_guard lock(mutex_);
  ++count_;
  if (messages_.size() < kept_messages) messages_.push_back(std::move(message));
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

void collect_messages(MessageLog& log) {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, &log);
}

}  // namespace throng::render::gl
