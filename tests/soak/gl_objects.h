#pragma once

#include <cstdint>

namespace throng::soak {

/// Returns how many objects the current OpenGL context has: buffers, textures, framebuffers and all others that have
/// names, but for programs and shaders.
std::uint64_t count_gl_objects();

/// Returns how many programs and shaders it has.
std::uint64_t count_gl_programs();

}  // namespace throng::soak
