#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// The paper's interpolation structures (2.2.2), one a bone, in packets of 16 bones. They have the control keys around
/// the current time. They are the private part of a keyframe player's block: plain bytes, relocatable, copied with it.
///
///      0          64 x 4     64 x 8      64 x 11    64 x 14    64 x 17    64 x 20 = 80 bytes a bone
///     | from xyzw | to xyzw  | from xyz  | to xyz   | timing   | timing   |
///     '------ rotation ------'------ position ------' rotation ' position '
///
/// and on the general path, behind it
///
///     | from xyz  | to xyz   | timing   |                                   + 36 = 116 bytes a bone
///     '------------ scale ---------------'
struct SegmentTiming {
  std::int32_t start[packet_bones];          ///< time units
  float reciprocal_span[packet_bones];       ///< 0: `from` holds
  std::uint32_t arriving_key[packet_bones];  ///< index of the `to` key in the stream, which keeps CUBICSPLINE tangents
};
struct RigidInterpolation {
  float rotation_from[4][packet_bones];
  float rotation_to[4][packet_bones];
  float position_from[3][packet_bones];
  float position_to[3][packet_bones];
  SegmentTiming rotation;
  SegmentTiming position;
};
struct ScaleInterpolation {
  float scale_from[3][packet_bones];
  float scale_to[3][packet_bones];
  SegmentTiming scale;
};
static_assert(sizeof(RigidInterpolation) == 80 * packet_bones,
              "a keyframe player of 62 bones must fit beside its state");
static_assert(sizeof(ScaleInterpolation) == 36 * packet_bones);

/// Returns the bytes of the interpolation structures of one packet: 80 bytes a bone on rigid skeletons, 116 on others.
constexpr std::size_t interpolation_packet_bytes(int components) {
  return sizeof(RigidInterpolation) + (components == general_components ? sizeof(ScaleInterpolation) : 0);
}
constexpr std::size_t interpolation_bytes(int bone_count, int components) {
  return static_cast<std::size_t>(packets_for(bone_count)) * interpolation_packet_bytes(components);
}
static_assert(interpolation_bytes(62, rigid_components) == 5120);

/// The place of a forward-moving player in the stream's key order. 0 with zeroed bytes means "not started".
struct KeyframeCursor {
  std::uint32_t next_key = 0;  ///< 1 + index of the first event not yet met
};

/// Brings the control keys to `time` (0 to stream.duration). Reads on if time goes forward, else begins at the nearest
/// seek point. `interpolations` has interpolation_bytes, at least 4-byte aligned. The result depends on stream and time
/// alone, whatever the path that led there.
void advance_keyframes(const KeyframeStream& stream, Ticks time, KeyframeCursor& cursor,
                       std::span<std::byte> interpolations);

/// Evaluates one packet of 16 bones at the time of the last advance. `pose` is float [components][16]. It uses
/// additions, multiplications, divisions and square roots only, so the bits are the same on every machine.
void evaluate_keyframes(const KeyframeStream& stream, Ticks time, std::span<const std::byte> interpolations, int packet,
                        std::span<float> pose);

}  // namespace throng::anim
