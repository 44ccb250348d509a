#pragma once

#include <cstdint>

namespace throng::soak {

/// Returns how many objects the current OpenGL context has: buffers, textures, framebuffers, programs and all others
/// that have names.
std::uint64_t count_gl_objects();

}  // namespace throng::soak
