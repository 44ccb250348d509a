#pragma once

#include <string>

#include <glad/gl.h>

#include "engine/result.h"

namespace throng::render::gl {

/// Says in words what OpenGL found wrong in the calls since the last question, and forgets it: the first of its errors.
/// `what` is what was asked of the device, "this picture". It may wait for the device's driver, so ask once a frame.
Status take_errors(const std::string& what);

/// Says whether a framebuffer can be drawn into, and in words why not; `what` as above.
Status check_complete(GLuint framebuffer, const std::string& what);

}  // namespace throng::render::gl
