#include "engine/anim/asset/marker_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace throng::anim {
namespace {

struct Markers {
  std::array<FineTicks, MarkerMap::most_markers> positions{};
  std::array<std::uint32_t, MarkerMap::most_markers> names{};
  std::size_t count = 0;
  bool usable = true;

  void insert(FineTicks position, std::uint32_t name) {
    if (count == MarkerMap::most_markers) usable = false;
    if (!usable) return;
    std::size_t place = count++;
    for (; place > 0 && positions[place - 1] > position; --place) {
      positions[place] = positions[place - 1];
      names[place] = names[place - 1];
    }
    if (place > 0 && positions[place - 1] == position) usable = false;
    positions[place] = position;
    names[place] = name;
  }
};

// A key at the duration is the start of the next loop.
Markers markers_of(const MarkedClip& clip, const MarkedClip& other) {
  Markers markers;
  for (const DataKey& key : clip.keys) {
    if (std::ranges::find(other.keys, key.name, &DataKey::name) == other.keys.end()) continue;
    markers.insert(key.time % clip.duration * fine_ticks_per_tick, key.name);
    if (!markers.usable) break;
  }
  return markers;
}

bool agree(const Markers& a, const Markers& b, std::size_t turned_by) {
  for (std::size_t i = 0; i < a.count; ++i) {
    if (a.names[i] != b.names[(i + turned_by) % b.count]) return false;
  }
  return true;
}

double phase(FineTicks position, FineTicks length) {
  return static_cast<double>(position) / static_cast<double>(length);
}

FineTicks wrapped(FineTicks position, FineTicks length) { return position - whole_loops(position, length) * length; }

// Several rotations agree where steps repeat, as in left right left right. This takes the rotation of least shift.
std::size_t best_turn(const Markers& a, FineTicks a_length, const Markers& b, FineTicks b_length) {
  std::size_t best = b.count;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < b.count; ++turn) {
    if (!agree(a, b, turn)) continue;
    double shift = 0.0;
    for (std::size_t i = 0; i < a.count; ++i) {
      const double there = phase(b.positions[(i + turn) % b.count], b_length);
      shift += std::abs(std::remainder(there - phase(a.positions[i], a_length), 1.0));
    }
    if (shift >= least) continue;
    least = shift;
    best = turn;
  }
  return best;
}

}  // namespace

MarkerMap::MarkerMap(const MarkedClip& leader, const MarkedClip& follower)
    : leader_length_(leader.duration * fine_ticks_per_tick), follower_length_(follower.duration * fine_ticks_per_tick) {
  assert(leader.duration > Ticks{} && follower.duration > Ticks{});
  const Markers a = markers_of(leader, follower);
  const Markers b = markers_of(follower, leader);
  if (!a.usable || !b.usable || a.count == 0 || a.count != b.count) return;
  const std::size_t turn = best_turn(a, leader_length_, b, follower_length_);
  if (turn == b.count) return;
  count_ = a.count;
  has_markers_ = true;
  leader_ = a.positions;
  for (std::size_t i = 0; i < count_; ++i) follower_[i] = b.positions[(i + turn) % count_];
}

MarkerMap::Way MarkerMap::way(FineTicks leader) const {
  assert(0 <= leader && leader < leader_length_);
  const auto after = std::upper_bound(leader_.begin(), leader_.begin() + static_cast<std::ptrdiff_t>(count_), leader);
  const bool before_first = after == leader_.begin();
  const std::size_t next = static_cast<std::size_t>(after - leader_.begin()) % count_;
  const std::size_t last = (next + count_ - 1) % count_;
  Way way{.begin = leader_[last],
          .end = leader_[next],
          .from = follower_[last],
          .length = wrapped(follower_[next] - follower_[last] - 1, follower_length_) + 1,  // a whole loop of one marker
          .loop = follower_length_,
          .has_markers = has_markers_};
  if (before_first) {
    way.begin -= leader_length_;
  } else if (next == 0) {
    way.end += leader_length_;
  }
  way.rate = static_cast<double>(way.length) / static_cast<double>(way.end - way.begin);
  return way;
}

// Rounded down and held before the next marker, so that both clips have met the same markers.
FineTicks MarkerMap::Way::position(FineTicks leader) const {
  const auto gone = static_cast<FineTicks>(static_cast<double>(leader - begin) * rate);
  return wrapped(from + std::min(gone, length - 1), loop);
}

}  // namespace throng::anim
