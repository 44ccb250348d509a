#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/units.h"
#include "engine/anim/kernel/pose.h"

namespace throng::anim {

/// The clip's own keys (paper 2.2.2, DESIGN section 4): one relocatable read-only block, rotation, position and scale
/// keys split, in state space, sorted in the order in which a player that moves forward needs them, with LINEAR, STEP
/// and CUBICSPLINE kept, and seek points for other moves. Exact: the reference that errors are measured against. The
/// layout behind this header is drawn in keyframe_stream.cpp's room and is the kernel's business alone.
struct alignas(64) KeyframeStream {
  std::uint32_t total_size;  ///< bytes, this header included
  std::int32_t bone_count;
  std::int32_t components;
  std::int32_t key_count;
  Ticks duration;
  std::uint32_t offsets[10];  ///< of the tables of the block, from its start
};
static_assert(sizeof(KeyframeStream) == 64);

/// A 64-byte aligned block holding the stream of `clip` on `skeleton`.
std::vector<std::byte> build_keyframe_stream(const Skeleton& skeleton, const Clip& clip);

}  // namespace throng::anim
