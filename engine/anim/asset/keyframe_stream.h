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

/// The property that a track moves, and how many floats a key of it has.
enum class KeyChannel : std::uint8_t { rotation, position, scale };
inline constexpr int key_channels = 3;
constexpr int key_width(KeyChannel channel) { return channel == KeyChannel::rotation ? 4 : 3; }

/// A key with the moment at which a player that moves forward needs it: when it becomes the control key that a track
/// moves towards (LINEAR, CUBICSPLINE), or the key that it shows (STEP).
///
///      0        4                 8       12               16     18        19        20
///     | start  | reciprocal_span | value | previous_value | bone | channel | is_cubic |
///
/// An event says everything about the segment that it opens, so a track's state follows from its latest event.
struct KeyEvent {
  std::int32_t start;            ///< time units (see time_shift) at which the segment begins
  float reciprocal_span;         ///< 1 / time units up to the key; 0: `previous_value` holds
  std::uint32_t value;           ///< the key's first float: an index into its channel's table
  std::uint32_t previous_value;  ///< the same for the key before it; equals `value` for STEP
  std::uint16_t bone;
  KeyChannel channel;
  std::uint8_t is_cubic;  ///< the segment's two tangents lie after the key's value, see below
};
static_assert(sizeof(KeyEvent) == 20);

/// The clip's own keys (paper 2.2.2) in one relocatable read-only block. Rotation, position and scale keys are apart,
/// in state space, sorted in the order in which a player that moves forward needs them. LINEAR, STEP and CUBICSPLINE
/// are kept, and seek points serve other moves. The stream is exact: errors are measured against it.
///
///     KeyframeStream                              64 bytes
///     constants    float [packet][component][16]  the pose of all that stays still; padding lanes: identity
///     cubic_lanes  uint16 [packet][3]             a bit for each lane whose track is CUBICSPLINE
///     events       KeyEvent [event_count]         one a track that opens it, then the others by start, bone, channel
///     seek points  uint32 [seek_count][tracks]    each track's latest event, every seek_interval events
///     values       float                          rotations, positions, scales, each in the order of the events
///
/// A LINEAR or STEP key is its value: 4 floats (unit, each on the hemisphere of the one before) or 3. A CUBICSPLINE key
/// has three parts: its value, the out-tangent of the key before and its own in-tangent. Both tangents are multiplied
/// by the span between the keys. Tables start at multiples of 64 bytes.
struct alignas(64) KeyframeStream {
  std::uint32_t total_size;  ///< bytes, this header included
  std::int32_t bone_count;
  std::int32_t components;
  std::int32_t time_shift;  ///< a time unit is 2^time_shift ticks, so that the whole clip fits in 31 bits
  Ticks duration;
  std::uint32_t event_count;
  std::uint32_t track_count;  ///< moving tracks
  std::uint32_t seek_interval;
  std::uint32_t constants_offset;  ///< bytes from the start of the block, like all that follow
  std::uint32_t cubic_lanes_offset;
  std::uint32_t events_offset;
  std::uint32_t seek_points_offset;
  std::uint32_t values_offsets[key_channels];

  std::int32_t time_units(Ticks time) const { return static_cast<std::int32_t>(time.count() >> time_shift); }
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

/// Builds the stream of `clip` on `skeleton` in a 64-byte aligned block of `total_size` bytes.
AlignedBytes build_keyframe_stream(const Skeleton& skeleton, const Clip& clip);

/// Builds the stream of the same clip on a skeleton whose bones have other places; `places` has the new index of each.
/// It has the bits of a stream that is built on that skeleton, because bones keep their values and their times.
AlignedBytes reorder_keyframe_stream(const KeyframeStream& stream, std::span<const int> places);

}  // namespace throng::anim
