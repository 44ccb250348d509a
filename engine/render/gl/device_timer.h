#pragma once

#include "engine/render/gl/handles.h"

namespace throng::render::gl {

inline void delete_query(GLuint id) { glDeleteQueries(1, &id); }

/// Measures how long the device takes for commands, by its own clock (GL_TIME_ELAPSED). A processor that draws has no
/// clock of its own: its drivers give times that mean nothing.
class DeviceTimer {
 public:
  DeviceTimer()
      : query_(create_one([](GLsizei count, GLuint* ids) { glCreateQueries(GL_TIME_ELAPSED, count, ids); })) {}

  void begin() { glBeginQuery(GL_TIME_ELAPSED, query_.id()); }
  void end() { glEndQuery(GL_TIME_ELAPSED); }
  /// Waits until the commands between begin() and end() are done, and returns their milliseconds.
  double milliseconds() const {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query_.id(), GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1e-6;
  }

 private:
  Handle<delete_query> query_;
};

}  // namespace throng::render::gl
