#include "engine/anim/asset/keyframe_stream.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <tuple>

#include "engine/anim/asset/keyframe_stream_clip.h"

namespace throng::anim {

namespace {

constexpr std::uint32_t least_seek_interval = 64;

/// An event before its values have a place in the tables.
struct PendingEvent {
  KeyEvent event;
  std::uint32_t track;
  std::uint32_t key;
};

int choose_time_shift(Ticks duration) {
  int shift = 0;
  while ((duration >> shift) > INT32_MAX / 2) ++shift;
  return shift;
}

/// Returns key times in units, strictly ascending. The earlier of two keys in one unit moves down, so that no segment
/// is empty.
std::vector<std::int32_t> unit_times(const StateTrack& track, int time_shift) {
  std::vector<std::int32_t> units;
  for (const StateKey& key : track.keys) units.push_back(static_cast<std::int32_t>(key.time >> time_shift));
  for (std::size_t k = units.size() - 1; k > 0; --k) units[k - 1] = std::min(units[k - 1], units[k] - 1);
  return units;
}

/// Makes the event of key `k` of a track: at the key's own time with STEP, else at the start of the segment before it.
PendingEvent event_of_key(const StateTrack& track, std::uint32_t index, const std::vector<std::int32_t>& units,
                          std::size_t k) {
  PendingEvent pending{.event = {}, .track = index, .key = static_cast<std::uint32_t>(k)};
  pending.event.bone = static_cast<std::uint16_t>(track.bone);
  pending.event.channel = track.channel;
  pending.event.is_cubic = track.interpolation == Interpolation::cubic_spline ? 1 : 0;
  if (track.interpolation == Interpolation::step) {
    pending.event.start = units[k];
  } else {
    pending.event.start = units[k - 1];
    pending.event.reciprocal_span = 1.0F / static_cast<float>(units[k] - units[k - 1]);
  }
  return pending;
}

/// Returns first the events that open each track, in the order of tracks, then all others as a forward player meets
/// them.
std::vector<PendingEvent> sorted_events(const StateClip& clip, int time_shift) {
  std::vector<PendingEvent> events;
  std::vector<PendingEvent> later;
  for (std::uint32_t t = 0; t < clip.tracks.size(); ++t) {
    const StateTrack& track = clip.tracks[t];
    const std::vector<std::int32_t> units = unit_times(track, time_shift);
    const std::size_t opening = track.interpolation == Interpolation::step ? 0 : 1;
    events.push_back(event_of_key(track, t, units, opening));
    for (std::size_t k = opening + 1; k < units.size(); ++k) later.push_back(event_of_key(track, t, units, k));
  }
  std::ranges::sort(later, {}, [](const PendingEvent& p) { return std::tuple(p.event.start, p.track); });
  events.insert(events.end(), later.begin(), later.end());
  return events;
}

using ValueTables = std::array<std::vector<float>, key_channels>;

/// Appends a key in the stream's form; `before` is the key before it, or null for the first key of its track.
std::uint32_t append_key(std::vector<float>& table, const StateTrack& track, const StateKey& key,
                         const StateKey* before) {
  const auto place = static_cast<std::uint32_t>(table.size());
  const auto append = [&](const glm::dvec4& value) {
    for (int i = 0; i < key_width(track.channel); ++i) table.push_back(static_cast<float>(value[i]));
  };
  append(key.value);
  if (track.interpolation == Interpolation::cubic_spline) {
    const double span = before != nullptr ? to_seconds(key.time - before->time) : 0.0;
    append(before != nullptr ? before->out_tangent * span : glm::dvec4(0.0));
    append(key.in_tangent * span);
  }
  return place;
}

/// Gives the values of all events their place, in the order of the events.
ValueTables place_values(const StateClip& clip, std::vector<PendingEvent>& events) {
  ValueTables tables;
  std::vector<std::uint32_t> latest(clip.tracks.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    auto& [event, t, k] = events[i];
    const StateTrack& track = clip.tracks[t];
    std::vector<float>& table = tables[static_cast<std::size_t>(track.channel)];
    const bool opens = i < clip.tracks.size();
    if (opens && k > 0) latest[t] = append_key(table, track, track.keys[0], nullptr);
    event.value = append_key(table, track, track.keys[k], k > 0 ? &track.keys[k - 1] : nullptr);
    event.previous_value = track.interpolation == Interpolation::step ? event.value : latest[t];
    latest[t] = event.value;
  }
  return tables;
}

std::vector<std::uint32_t> seek_points(const std::vector<PendingEvent>& events, std::size_t tracks,
                                       std::uint32_t interval) {
  std::vector<std::uint32_t> latest(tracks);
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < events.size(); ++i) {
    latest[events[i].track] = i;
    if (i + 1 >= tracks && (i + 1 - tracks) % interval == 0) points.insert(points.end(), latest.begin(), latest.end());
  }
  return points;
}

std::vector<float> constant_pose(const StateClip& clip) {
  const auto bones = static_cast<int>(clip.constants.size());
  const int lanes = packets_for(bones) * packet_bones;
  std::vector<float> pose(static_cast<std::size_t>(lanes * clip.components));
  for (int bone = 0; bone < lanes; ++bone) {
    const StateTransform state = bone < bones ? clip.constants[static_cast<std::size_t>(bone)] : StateTransform{};
    const double components[general_components] = {
        state.rotation.x, state.rotation.y, state.rotation.z, state.rotation.w, state.position.x,
        state.position.y, state.position.z, state.scale.x,    state.scale.y,    state.scale.z};
    for (int c = 0; c < clip.components; ++c) {
      const int place = (bone / packet_bones * clip.components + c) * packet_bones + bone % packet_bones;
      pose[static_cast<std::size_t>(place)] = static_cast<float>(components[c]);
    }
  }
  return pose;
}

std::vector<std::uint16_t> cubic_lanes(const StateClip& clip) {
  std::vector<std::uint16_t> lanes(
      static_cast<std::size_t>(packets_for(static_cast<int>(clip.constants.size())) * key_channels));
  for (const StateTrack& track : clip.tracks) {
    if (track.interpolation != Interpolation::cubic_spline) continue;
    const int place = track.bone / packet_bones * key_channels + static_cast<int>(track.channel);
    auto& mask = lanes[static_cast<std::size_t>(place)];
    mask = static_cast<std::uint16_t>(mask | 1U << (track.bone % packet_bones));
  }
  return lanes;
}

/// Lays tables behind a header one after the other, each at a multiple of 64 bytes.
class BlockLayout {
 public:
  template <typename T>
  std::uint32_t append(const std::vector<T>& table) {
    const std::size_t offset = size_;
    const std::size_t bytes = table.size() * sizeof(T);
    parts_.push_back({offset, table.data(), bytes});
    size_ = (offset + bytes + block_alignment - 1) / block_alignment * block_alignment;
    assert(size_ <= UINT32_MAX);
    return static_cast<std::uint32_t>(offset);
  }
  std::size_t size() const { return size_; }
  void copy_to(std::byte* block) const {
    for (const Part& part : parts_) {
      if (part.size > 0) std::memcpy(block + part.offset, part.data, part.size);
    }
  }

 private:
  struct Part {
    std::size_t offset;
    const void* data;
    std::size_t size;
  };
  std::size_t size_ = sizeof(KeyframeStream);
  std::vector<Part> parts_;
};

}  // namespace

AlignedBytes pack_keyframe_stream(const StateClip& clip) {
  const int time_shift = choose_time_shift(clip.duration);
  std::vector<PendingEvent> pending = sorted_events(clip, time_shift);
  const ValueTables values = place_values(clip, pending);
  const auto tracks = static_cast<std::uint32_t>(clip.tracks.size());
  const std::uint32_t interval = std::max(least_seek_interval, 2 * tracks);
  std::vector<KeyEvent> events;
  events.reserve(pending.size());
  for (const PendingEvent& p : pending) events.push_back(p.event);
  const std::vector<float> constants = constant_pose(clip);
  const std::vector<std::uint16_t> lanes = cubic_lanes(clip);
  const std::vector<std::uint32_t> seeks = seek_points(pending, tracks, interval);

  BlockLayout layout;
  KeyframeStream header{};
  header.bone_count = static_cast<std::int32_t>(clip.constants.size());
  header.components = clip.components;
  header.time_shift = time_shift;
  header.duration = clip.duration;
  header.event_count = static_cast<std::uint32_t>(events.size());
  header.track_count = tracks;
  header.seek_interval = interval;
  header.constants_offset = layout.append(constants);
  header.cubic_lanes_offset = layout.append(lanes);
  header.events_offset = layout.append(events);
  header.seek_points_offset = layout.append(seeks);
  for (int c = 0; c < key_channels; ++c) header.values_offsets[c] = layout.append(values[static_cast<std::size_t>(c)]);
  header.total_size = static_cast<std::uint32_t>(layout.size());

  AlignedBytes block = allocate_aligned(header.total_size);
  std::memcpy(block.get(), &header, sizeof(header));
  layout.copy_to(block.get());
  return block;
}

AlignedBytes build_keyframe_stream(const Skeleton& skeleton, const Clip& clip) {
  return pack_keyframe_stream(to_state_space(skeleton, clip));
}

}  // namespace throng::anim
