#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// What a track moves, and how many floats a key of it has.
enum class KeyChannel : std::uint8_t { rotation, position, scale };
inline constexpr int key_channels = 3;
constexpr int key_width(KeyChannel channel) { return channel == KeyChannel::rotation ? 4 : 3; }

/// A key at the moment when a player that moves forward needs it: when it becomes the control key that a track moves
/// towards (LINEAR, CUBICSPLINE), or the one that it shows (STEP).
///
///      0        4                 8       12               16     18        19        20
///     | start  | reciprocal_span | value | previous_value | bone | channel | is_cubic |
///
/// An event says everything about the segment it opens, so the state of a track is a function of its latest event.
struct KeyEvent {
  std::int32_t start;            ///< time units (see time_shift): the segment runs from here
  float reciprocal_span;         ///< 1 / time units up to the key; 0: `previous_value` holds
  std::uint32_t value;           ///< of the key: index of its first float in its channel's table
  std::uint32_t previous_value;  ///< of the key before it; the same as `value` for STEP
  std::uint16_t bone;
  KeyChannel channel;
  std::uint8_t is_cubic;  ///< after the key's value lie the segment's two tangents, see below
};
static_assert(sizeof(KeyEvent) == 20);

/// The clip's own keys (paper 2.2.2): one relocatable read-only block, rotation, position and scale keys split, in
/// state space, sorted in the order in which a player that moves forward needs them, with LINEAR, STEP and CUBICSPLINE
/// kept, and seek points for other moves. Exact: the reference that errors are measured against.
///
///     KeyframeStream                              64 bytes
///     constants    float [packet][component][16]  the pose of what does not move; padding lanes: identity
///     cubic_lanes  uint16 [packet][3]             a bit for each lane whose track is CUBICSPLINE
///     events       KeyEvent [event_count]         one a track that opens it, then others by start, bone, channel
///     seek points  uint32 [seek_count][tracks]    each track's latest event, every seek_interval events
///     values       float                          rotations, positions, scales, each in the order of the events
///
/// A LINEAR or STEP key is its value: 4 floats (unit, each on the hemisphere of the one before) or 3. A CUBICSPLINE key
/// is three of them: value, out-tangent of the key before and in-tangent of this key, both times the span between them.
/// Tables start at multiples of 64 bytes.
struct alignas(64) KeyframeStream {
  std::uint32_t total_size;  ///< bytes, this header included
  std::int32_t bone_count;
  std::int32_t components;
  std::int32_t time_shift;  ///< a time unit is 2^time_shift ticks, so that the whole clip fits in 31 bits
  Ticks duration;
  std::uint32_t event_count;
  std::uint32_t track_count;  ///< tracks that move
  std::uint32_t seek_interval;
  std::uint32_t constants_offset;  ///< bytes from the start of the block, as all that follow
  std::uint32_t cubic_lanes_offset;
  std::uint32_t events_offset;
  std::uint32_t seek_points_offset;
  std::uint32_t values_offsets[key_channels];

  std::int32_t time_units(Ticks time) const { return static_cast<std::int32_t>(time >> time_shift); }
  const float* constants(int packet) const {
    return at<float>(constants_offset) + static_cast<std::ptrdiff_t>(packet) * components * packet_bones;
  }
  std::uint16_t cubic_lanes(int packet, KeyChannel channel) const {
    return at<std::uint16_t>(cubic_lanes_offset)[packet * key_channels + static_cast<int>(channel)];
  }
  std::span<const KeyEvent> events() const { return {at<KeyEvent>(events_offset), event_count}; }
  std::span<const std::uint32_t> seek_point(std::size_t index) const {
    return {at<std::uint32_t>(seek_points_offset) + index * track_count, track_count};
  }
  const float* values(KeyChannel channel) const { return at<float>(values_offsets[static_cast<int>(channel)]); }

 private:
  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
};
static_assert(sizeof(KeyframeStream) == 64, "the header of a stream is one cache line");
static_assert(offsetof(KeyframeStream, duration) == 16);
static_assert(offsetof(KeyframeStream, constants_offset) == 36);
static_assert(offsetof(KeyframeStream, values_offsets) == 52);

/// A 64-byte aligned block holding the stream of `clip` on `skeleton`; it is `total_size` bytes long.
AlignedBytes build_keyframe_stream(const Skeleton& skeleton, const Clip& clip);

}  // namespace throng::anim
