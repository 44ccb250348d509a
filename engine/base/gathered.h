#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/tiles.h"

namespace throng {

/// A list that jobs make together, tile by tile. It has the same order for any number of them.
template <typename Element>
class Gathered {
 public:
  /// Makes room to pick from `count` numbers, so that gather() allocates nothing.
  void set_aside(std::size_t count) {
    room_.resize(count);
    picked_.resize((count + SharedTiles::tile - 1) / SharedTiles::tile);
  }

  /// Calls pick(i, Element& element) for each i below `count`, as many as were set aside at most. Where it returns
  /// true, the list gets that element. Returns the list in the order of i; it holds until the next call.
  template <typename Pick>
  std::span<const Element> gather(std::size_t count, Executor& executor, int jobs, const Pick& pick) {
    visit_tiles(count, executor, jobs, [&](std::size_t first, std::size_t end) {
      std::size_t next = first;
      for (std::size_t i = first; i < end; ++i) next += pick(i, room_[next]) ? 1U : 0U;
      picked_[first / SharedTiles::tile] = static_cast<std::uint32_t>(next - first);
    });
    return {room_.data(), close_gaps(count)};
  }

 private:
  std::size_t close_gaps(std::size_t count) {
    std::size_t listed = 0;
    for (std::size_t first = 0; first < count; first += SharedTiles::tile) {
      const auto from = room_.begin() + static_cast<std::ptrdiff_t>(first);
      const std::uint32_t some = picked_[first / SharedTiles::tile];
      if (listed != first) std::copy(from, from + some, room_.begin() + static_cast<std::ptrdiff_t>(listed));
      listed += some;
    }
    return listed;
  }

  std::vector<Element> room_;
  std::vector<std::uint32_t> picked_;  // [tile]
};

}  // namespace throng
