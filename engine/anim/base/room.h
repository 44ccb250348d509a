#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace throng::anim {

/// Makes room in `list` for `count` elements. Memory grows by half at least, so that a list that grows one by one is
/// copied a few times and not each time.
template <typename Element>
void make_room(std::vector<Element>& list, std::size_t count) {
  if (count > list.capacity()) list.reserve(std::max(count, list.capacity() + list.capacity() / 2));
}

}  // namespace throng::anim
