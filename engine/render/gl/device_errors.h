#pragma once

#include <string>

#include <glad/gl.h>

#include "engine/base/result.h"

namespace throng::render::gl {

/// Says in words the first error of OpenGL in the calls since the last question, and forgets it.
/// `what` names the request to the device, "this picture". It may wait for the device's driver, so ask once a frame.
Status take_errors(const std::string& what);

/// Says whether a framebuffer can be drawn into, or in words why not; `what` is as above.
Status check_complete(GLuint framebuffer, const std::string& what);

}  // namespace throng::render::gl
