#include "engine/anim/kernel/keyframe/keyframe_player.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace throng::anim {

namespace {

RigidInterpolation& rigid_part(std::byte* packet) { return *reinterpret_cast<RigidInterpolation*>(packet); }
ScaleInterpolation& scale_part(std::byte* packet) {
  return *reinterpret_cast<ScaleInterpolation*>(packet + sizeof(RigidInterpolation));
}

/// The lanes of one channel of one packet, which an event writes.
struct ChannelLanes {
  float (*from)[packet_bones];
  float (*to)[packet_bones];
  SegmentTiming* timing;
};

ChannelLanes channel_lanes(std::byte* packet, KeyChannel channel) {
  RigidInterpolation& rigid = rigid_part(packet);
  switch (channel) {
    case KeyChannel::rotation:
      return {rigid.rotation_from, rigid.rotation_to, &rigid.rotation};
    case KeyChannel::position:
      return {rigid.position_from, rigid.position_to, &rigid.position};
    case KeyChannel::scale:
      break;
  }
  ScaleInterpolation& scale = scale_part(packet);
  return {scale.scale_from, scale.scale_to, &scale.scale};
}

/// The latest event alone decides the state of a track.
void apply_event(const KeyframeStream& stream, const KeyEvent& event, std::span<std::byte> interpolations) {
  const std::size_t packet = event.bone / packet_bones;
  const int lane = event.bone % packet_bones;
  const ChannelLanes lanes =
      channel_lanes(interpolations.data() + packet * interpolation_packet_bytes(stream.components), event.channel);
  const float* values = stream.values(event.channel);
  for (int i = 0; i < key_width(event.channel); ++i) {
    lanes.from[i][lane] = values[event.previous_value + static_cast<std::uint32_t>(i)];
    lanes.to[i][lane] = values[event.value + static_cast<std::uint32_t>(i)];
  }
  lanes.timing->start[lane] = event.start;
  lanes.timing->reciprocal_span[lane] = event.reciprocal_span;
  lanes.timing->arriving_key[lane] = event.value;
}

/// Every lane holds its constant, for ever.
void hold_constants(const KeyframeStream& stream, std::span<std::byte> interpolations) {
  std::ranges::fill(interpolations, std::byte{0});
  const std::size_t stride = interpolation_packet_bytes(stream.components);
  for (int p = 0; p < packets_for(stream.bone_count); ++p) {
    std::byte* packet = interpolations.data() + static_cast<std::size_t>(p) * stride;
    const float* constants = stream.constants(p);
    const auto hold = [&](KeyChannel channel, int first_component) {
      const ChannelLanes lanes = channel_lanes(packet, channel);
      const std::size_t size = sizeof(float) * packet_bones * static_cast<std::size_t>(key_width(channel));
      std::memcpy(lanes.from, constants + first_component * packet_bones, size);
      std::memcpy(lanes.to, constants + first_component * packet_bones, size);
    };
    hold(KeyChannel::rotation, 0);
    hold(KeyChannel::position, 4);
    if (stream.components == general_components) hold(KeyChannel::scale, rigid_components);
  }
}

/// Number of events that a player at `now` has met: events that open tracks, and all that have begun.
std::uint32_t events_met(const KeyframeStream& stream, std::int32_t now) {
  const auto later = stream.events().subspan(stream.track_count);
  const auto end = std::ranges::upper_bound(later, now, {}, &KeyEvent::start);
  return stream.track_count + static_cast<std::uint32_t>(end - later.begin());
}

/// Takes every track to where it stood at the last seek point at or before `now`; returns the events met there.
std::uint32_t restore_seek_point(const KeyframeStream& stream, std::int32_t now, std::span<std::byte> interpolations) {
  const std::uint32_t index = (events_met(stream, now) - stream.track_count) / stream.seek_interval;
  const auto events = stream.events();
  for (const std::uint32_t event : stream.seek_point(index)) apply_event(stream, events[event], interpolations);
  return stream.track_count + index * stream.seek_interval;
}

/// Reading on costs less than a seek only forward, and only nearby.
bool reads_on(const KeyframeStream& stream, std::uint32_t met, std::int32_t now) {
  const auto events = stream.events();
  const bool backward = met > stream.track_count && events[met - 1].start > now;
  const std::uint32_t far = met + stream.seek_interval + stream.track_count;
  const bool far_ahead = far < stream.event_count && events[far].start <= now;
  return !backward && !far_ahead;
}

}  // namespace

void advance_keyframes(const KeyframeStream& stream, Ticks time, KeyframeCursor& cursor,
                       std::span<std::byte> interpolations) {
  assert(time >= Ticks{} && time <= stream.duration);
  assert(interpolations.size() >= interpolation_bytes(stream.bone_count, stream.components));
  const std::int32_t now = stream.time_units(time);
  const bool started = cursor.next_key != 0;
  if (!started) {
    hold_constants(stream, interpolations.first(interpolation_bytes(stream.bone_count, stream.components)));
  }
  std::uint32_t met = started ? cursor.next_key - 1 : 0;
  if (!started || !reads_on(stream, met, now)) met = restore_seek_point(stream, now, interpolations);
  const auto events = stream.events();
  while (met < events.size() && events[met].start <= now) apply_event(stream, events[met++], interpolations);
  cursor.next_key = met + 1;
}

}  // namespace throng::anim
