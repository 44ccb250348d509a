#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "throng/render/crowd_draw.h"

#include "engine/render/gl/handles.h"

namespace throng::render {

/// The bindings of the blocks, which are the same in every program.
enum UniformBinding : unsigned { frame_uniforms_binding = 0, light_uniforms_binding = 1, shadow_uniforms_binding = 2 };
enum StorageBinding : unsigned {
  instances_binding = 0,
  palette_binding = 1,
  palette_entries_binding = 2,
  packing_frames_binding = 3,
  morph_firsts_binding = 4,
  morph_entries_binding = 5,
  morph_weights_binding = 6,
  scenery_binding = 7,
  drawn_binding = 8,
  cells_binding = 9,
  looks_binding = 10
};
/// The texture units of the light, which are the same in every program; materials have the units before.
enum LightUnit : unsigned {
  shadow_maps_unit = 8,
  sky_unit = 9,
  environment_unit = 10,
  crowd_map_unit = 11,
  lamp_map_unit = 12
};

/// Block 0 of every scene program. `shaders/frame_uniforms.glsl` repeats the layout (std140).
///
///      0  view projection
///     64  camera position x y z, unused
///     80  right, up, forward, w unused: forward + x * right + y * up is the ray of place (x, y) in clip space
///    128  now in microseconds, distance scale, first and number of the palette entries whose weights are shown
///    144  shape of the ground: half sides of the core along x and z, radius of the corners, half width
///    160  whether the ground is endless, its unit, unused
struct FrameUniforms {
  glm::mat4 view_projection;
  glm::vec4 camera_position;
  glm::vec4 ray_right;
  glm::vec4 ray_up;
  glm::vec4 ray_forward;
  std::uint32_t now;
  float distance_scale;
  std::uint32_t weighed_entry;
  std::uint32_t weighed_entries;
  glm::vec4 ground_shape;
  std::uint32_t ground_is_endless;
  float ground_unit;
  float unused[2];
};
static_assert(sizeof(FrameUniforms) == 176);
static_assert(offsetof(FrameUniforms, camera_position) == 64);
static_assert(offsetof(FrameUniforms, now) == 128);
static_assert(offsetof(FrameUniforms, ground_shape) == 144);

/// Carries the camera, the time, the instance records and the weights of morphs of each frame to the device. Records
/// and weights take turns with several buffers, so that copying never waits for an earlier frame. Looks are copied when
/// their number changes.
class FrameData {
 public:
  /// Copies the data of a frame and binds it for every program.
  void upload(const CrowdFrame& frame);

  /// Copies a frame's camera and time alone, for another view of the same instances.
  void upload_view(const CrowdFrame& frame);

  /// Binds the instances of the batches, by their numbers, after shadows have bound their own.
  void bind_drawn() const;

 private:
  static constexpr std::size_t frames_in_flight = 3;

  void upload_looks(const CrowdFrame& frame);
  void upload_plain_looks(std::span<const InstanceRecord> instances);
  void upload_drawn(const CrowdFrame& frame);

  gl::Buffer uniforms_ = gl::create_buffer(nullptr, sizeof(FrameUniforms), GL_DYNAMIC_STORAGE_BIT);
  std::array<gl::GrowingBuffer<InstanceRecord>, frames_in_flight> instances_;
  std::array<gl::GrowingBuffer<float>, frames_in_flight> morph_weights_;
  std::array<gl::GrowingBuffer<std::uint32_t>, frames_in_flight> drawn_;
  gl::GrowingBuffer<std::uint32_t> all_;  // 0, 1, 2 ...: for frames whose batches are runs of instances
  std::size_t counted_ = 0;               // of all_
  bool draws_lists_ = false;
  gl::GrowingBuffer<AgentLook> looks_;
  std::uint64_t looks_number_ = 0;  // of the looks that were copied last; 0: none were
  std::size_t plain_looks_ = 0;     // that were copied last; 0: those of a frame were
  std::size_t turn_ = 0;
};

}  // namespace throng::render
