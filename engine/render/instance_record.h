#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::render {

inline constexpr std::uint32_t packed_slot = 0x80000000U;  ///< see InstanceRecord

inline constexpr int tint_regions = 5;       ///< skin, hair, shirt, trousers, shoes
inline constexpr float shade_reach = 0.35F;  ///< see InstanceRecord; shaders/variants.glsl repeats it

inline constexpr std::size_t weights_a_place = 4;           ///< see InstanceRecord::hair
inline constexpr std::size_t largest_weight_place = 65534;  ///< the last that a record can name

/// Tells the vertex shader about one drawn agent. `shaders/instance_record.glsl` repeats the layout (std430).
/// app/ writes it once a frame for every drawn agent.
///
///      0  position x y z          metres, world space, between the feet
///     12  scale                   uniform
///     16  heading cosine, sine    about +Y; 1, 0 faces +Z
///     24  palette from, to        first line of 64 bytes of each slot in the page's buffer; the highest bit says
///                                 that the slot is packed
///     32  blend start, duration   microseconds, modulo 2^32; shown = mix(from, to, clamp((now - start) / duration)),
///                                 duration 0 shows `to`
///     40  agent                   its index, for read-back and picking
///     44  debug color             RGBA8; alpha says how much of it shows (0: none)
///     48  tint of each region     RGBA8, sRGB
///     68  bone level              both slots hold at least the entries of this level
///     72  shape                   build (stout), frame (broad-shouldered), posture (stooped):
///                                 RGB8_SNORM in the low bytes
///     76  hair                    fullness and length: RG8_SNORM in the low bytes; 0 in both leaves the
///                                 surface as it is. The high half says where its weights of morphs begin
///                                 (CrowdFrame::morph_weights): 1 + number / weights_a_place; 0: it has none
///     80  contact scale           of the dark spot below; 1 fits a person of 1.8 metres
///     84  shade                   of what no tint region colours: RGB8_SNORM in the low bytes; 1 makes linear red,
///                                 green or blue 1 + shade_reach times as bright, 0 leaves it as it is
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
  std::uint32_t tints[tint_regions];
  std::uint32_t bone_level;
  std::uint32_t shape;
  std::uint32_t hair;
  float contact_scale;
  std::uint32_t shade;
};
static_assert(sizeof(InstanceRecord) == 88);
static_assert(offsetof(InstanceRecord, palette_from) == 24);
static_assert(offsetof(InstanceRecord, blend_start) == 32);
static_assert(offsetof(InstanceRecord, tints) == 48);
static_assert(offsetof(InstanceRecord, bone_level) == 68);
static_assert(offsetof(InstanceRecord, shape) == 72);
static_assert(offsetof(InstanceRecord, contact_scale) == 80);
static_assert(offsetof(InstanceRecord, shade) == 84);

}  // namespace throng::render
