#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::render {

inline constexpr std::uint32_t packed_slot = 0x80000000U;  ///< see InstanceRecord

/// Tells the vertex shader about one drawn agent in one frame; its constant data is in its AgentLook.
/// `shaders/instance_record.glsl` repeats the layout (std430). It is written once a frame for every drawn agent.
///
///      0  position x y z          metres, world space, between the feet
///     12  scale                   uniform
///     16  heading cosine, sine    about +Y; 1, 0 faces +Z
///     24  palette from, to        first line of 64 bytes of each slot in the page's buffer; the highest bit says
///                                 that the slot is packed
///     32  blend start, duration   microseconds, modulo 2^32; shown = mix(from, to, clamp((now - start) / duration)),
///                                 duration 0 shows `to`
///     40  agent                   its index, among CrowdFrame::looks too
///     44  debug color             RGBA8; alpha says how much of it shows (0: none)
///     48  bone level              both slots hold at least the entries of this level
///     52  weights                 1 + the number of its first weight among CrowdFrame::morph_weights; 0: it has none
///     56  contact scale           of the dark spot below; 1 fits a person of 1.8 metres
struct InstanceRecord {
  float position[3];
  float scale;
  float heading_cosine;
  float heading_sine;
  std::uint32_t palette_from;
  std::uint32_t palette_to;
  std::uint32_t blend_start;
  std::uint32_t blend_duration;
  std::uint32_t agent;
  std::uint32_t debug_color;
  std::uint32_t bone_level;
  std::uint32_t weights;
  float contact_scale;
};
static_assert(sizeof(InstanceRecord) == 60);
static_assert(offsetof(InstanceRecord, palette_from) == 24);
static_assert(offsetof(InstanceRecord, blend_start) == 32);
static_assert(offsetof(InstanceRecord, agent) == 40);
static_assert(offsetof(InstanceRecord, bone_level) == 48);
static_assert(offsetof(InstanceRecord, weights) == 52);
static_assert(offsetof(InstanceRecord, contact_scale) == 56);

}  // namespace throng::render
