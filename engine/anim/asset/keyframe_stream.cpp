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
  while ((duration.count() >> shift) > INT32_MAX / 2) ++shift;
  return shift;
}

/// Returns key times in units, strictly ascending. The earlier of two keys in one unit moves down, so that no segment
/// is empty.
std::vector<std::int32_t> unit_times(const StateTrack& track, int time_shift) {
  std::vector<std::int32_t> units;
  for (const StateKey& key : track.keys) units.push_back(static_cast<std::int32_t>(key.time.count() >> time_shift));
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
  std::vector<float> pose(pose_bytes(bones, clip.components) / sizeof(float));
  for (int bone = 0; bone < packets_for(bones) * packet_bones; ++bone) {
    const StateTransform state = bone < bones ? clip.constants[static_cast<std::size_t>(bone)] : StateTransform{};
    store_state(state, bone, clip.components, pose.data());
  }
  return pose;
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

/// All parts of a stream that do not follow from others.
struct StreamParts {
  std::vector<PendingEvent> pending;
  ValueTables values;
  std::vector<float> constants;
};

/// `openings` are the events that open the tracks.
std::vector<std::uint16_t> cubic_lanes(int bone_count, std::span<const PendingEvent> openings) {
  std::vector<std::uint16_t> lanes(static_cast<std::size_t>(packets_for(bone_count) * key_channels));
  for (const auto& [event, track, key] : openings) {
    if (event.is_cubic == 0) continue;
    const int place = event.bone / packet_bones * key_channels + static_cast<int>(event.channel);
    auto& mask = lanes[static_cast<std::size_t>(place)];
    mask = static_cast<std::uint16_t>(mask | 1U << (event.bone % packet_bones));
  }
  return lanes;
}

/// `counts` has the counts of bones and components, the time shift and the duration.
AlignedBytes lay_out(const KeyframeStream& counts, const StreamParts& parts, std::uint32_t tracks) {
  const std::uint32_t interval = std::max(least_seek_interval, 2 * tracks);
  std::vector<KeyEvent> events;
  events.reserve(parts.pending.size());
  for (const PendingEvent& p : parts.pending) events.push_back(p.event);
  const std::vector<std::uint32_t> seeks = seek_points(parts.pending, tracks, interval);
  const std::vector<std::uint16_t> cubic = cubic_lanes(counts.bone_count, std::span(parts.pending).first(tracks));

  KeyframeStream header = counts;
  BlockLayout layout;
  header.event_count = static_cast<std::uint32_t>(events.size());
  header.track_count = tracks;
  header.seek_interval = interval;
  header.constants_offset = layout.append(parts.constants);
  header.cubic_lanes_offset = layout.append(cubic);
  header.events_offset = layout.append(events);
  header.seek_points_offset = layout.append(seeks);
  for (std::size_t c = 0; c < key_channels; ++c) header.values_offsets[c] = layout.append(parts.values[c]);
  header.total_size = static_cast<std::uint32_t>(layout.size());

  AlignedBytes block = allocate_aligned(header.total_size);
  std::memcpy(block.get(), &header, sizeof(header));
  layout.copy_to(block.get());
  return block;
}

/// Returns the events of a stream with their new bones, in the order of sorted_events.
std::vector<PendingEvent> reordered_events(const KeyframeStream& stream, std::span<const int> places) {
  std::vector<PendingEvent> events;
  for (const KeyEvent& event : stream.events()) {
    events.push_back({.event = event, .track = 0, .key = 0});
    events.back().event.bone = static_cast<std::uint16_t>(places[event.bone]);
  }
  const auto track = [](const PendingEvent& p) { return std::tuple(p.event.bone, p.event.channel); };
  const auto later = events.begin() + static_cast<std::ptrdiff_t>(stream.track_count);
  std::ranges::sort(events.begin(), later, {}, track);
  const std::span openings(events.begin(), later);
  for (PendingEvent& p : events) {
    const auto opening = std::ranges::lower_bound(openings, track(p), {}, track);
    p.track = static_cast<std::uint32_t>(opening - openings.begin());
  }
  std::ranges::sort(later, events.end(), {}, [](const PendingEvent& p) { return std::tuple(p.event.start, p.track); });
  return events;
}

/// Gives the values of reordered events their place; see place_values.
ValueTables move_values(const KeyframeStream& stream, std::vector<PendingEvent>& events) {
  ValueTables tables;
  std::vector<std::uint32_t> latest(stream.track_count);
  for (std::size_t i = 0; i < events.size(); ++i) {
    auto& [event, track, key] = events[i];
    std::vector<float>& table = tables[static_cast<std::size_t>(event.channel)];
    const auto copy = [&, channel = event.channel,
                       floats = key_width(event.channel) * (event.is_cubic != 0 ? 3 : 1)](std::uint32_t from) {
      const auto place = static_cast<std::uint32_t>(table.size());
      table.insert(table.end(), stream.values(channel) + from, stream.values(channel) + from + floats);
      return place;
    };
    const bool is_step = event.value == event.previous_value;
    if (i < stream.track_count && !is_step) latest[track] = copy(event.previous_value);
    event.value = copy(event.value);
    event.previous_value = is_step ? event.value : latest[track];
    latest[track] = event.value;
  }
  return tables;
}

std::vector<float> reordered_constants(const KeyframeStream& stream, std::span<const int> places) {
  const std::size_t floats = pose_bytes(stream.bone_count, stream.components) / sizeof(float);
  std::vector<float> pose(stream.constants(0), stream.constants(0) + floats);  // lanes without a bone stay
  for (std::size_t bone = 0; bone < places.size(); ++bone) {
    const auto from = static_cast<int>(bone), to = places[bone];
    for (int c = 0; c < stream.components; ++c) {
      const int place = (to / packet_bones * stream.components + c) * packet_bones + to % packet_bones;
      pose[static_cast<std::size_t>(place)] =
          stream.constants(from / packet_bones)[c * packet_bones + from % packet_bones];
    }
  }
  return pose;
}

}  // namespace

AlignedBytes pack_keyframe_stream(const StateClip& clip) {
  const int time_shift = choose_time_shift(clip.duration);
  StreamParts parts{.pending = sorted_events(clip, time_shift), .values = {}, .constants = constant_pose(clip)};
  parts.values = place_values(clip, parts.pending);
  KeyframeStream header{};
  header.bone_count = static_cast<std::int32_t>(clip.constants.size());
  header.components = clip.components;
  header.time_shift = time_shift;
  header.duration = clip.duration;
  return lay_out(header, parts, static_cast<std::uint32_t>(clip.tracks.size()));
}

AlignedBytes reorder_keyframe_stream(const KeyframeStream& stream, std::span<const int> places) {
  assert(places.size() == static_cast<std::size_t>(stream.bone_count));
  StreamParts parts{
      .pending = reordered_events(stream, places), .values = {}, .constants = reordered_constants(stream, places)};
  parts.values = move_values(stream, parts.pending);
  return lay_out(stream, parts, stream.track_count);
}

AlignedBytes build_keyframe_stream(const Skeleton& skeleton, const Clip& clip) {
  return pack_keyframe_stream(to_state_space(skeleton, clip));
}

}  // namespace throng::anim
