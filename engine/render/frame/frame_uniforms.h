#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "engine/render/crowd_draw.h"

namespace throng::render {

/// Is block 0 of every scene program. `shaders/frame_uniforms.glsl` repeats the layout (std140).
///
///      0  view projection
///     64  camera position x y z, unused
///     80  right, up, forward, w unused: forward + x * right + y * up is the ray of place (x, y) in clip space
///    128  now in microseconds, three unused
struct FrameUniforms {
  glm::mat4 view_projection;
  glm::vec4 camera_position;
  glm::vec4 ray_right;
  glm::vec4 ray_up;
  glm::vec4 ray_forward;
  std::uint32_t now;
  std::uint32_t unused[3];
};
static_assert(sizeof(FrameUniforms) == 144);
static_assert(offsetof(FrameUniforms, camera_position) == 64);
static_assert(offsetof(FrameUniforms, now) == 128);

FrameUniforms frame_uniforms(const CameraView& camera, std::uint32_t now);

/// Bindings of the blocks, the same in every program.
enum UniformBinding : unsigned { frame_uniforms_binding = 0 };
enum StorageBinding : unsigned {
  instances_binding = 0,
  palette_binding = 1,
  palette_entries_binding = 2,
  packing_frames_binding = 3
};

}  // namespace throng::render
