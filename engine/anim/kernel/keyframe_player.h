#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// The paper's interpolation structures (2.2.2): per bone, the control keys around the current time. They are the
/// private part of a keyframe player's block, packets of 16 bones, at most 80 bytes a bone (tangents stay in the
/// stream). Plain bytes: relocatable, copied with the block.
std::size_t interpolation_bytes(int bone_count, int components);

/// Where a forward-moving player stands in the stream's key order; 0 with zeroed bytes means "not started".
struct KeyframeCursor {
  std::uint32_t next_key = 0;
};

/// Brings the control keys to `time` (0 to stream.duration): forward by reading on, else from the nearest seek point.
/// The result depends on stream and time alone, whatever the path that led there.
void advance_keyframes(const KeyframeStream& stream, Ticks time, KeyframeCursor& cursor,
                       std::span<std::byte> interpolations);

/// Evaluates one packet of 16 bones at the time of the last advance; `pose` is float [components][16].
void evaluate_keyframes(const KeyframeStream& stream, Ticks time, std::span<const std::byte> interpolations, int packet,
                        std::span<float> pose);

}  // namespace throng::anim
