#include "engine/anim/base/pool_tables.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace throng::anim {

void PoolTables::copy_from(const PoolTables& other) {
  free_.reserve(other.places_.size());
  worn_.reserve(other.places_.size());
  *this = other;
}

bool PoolTables::alive(std::uint32_t index, std::uint32_t generation) const {
  return index < places_.size() && places_[index] != none && generations_[index] == generation;
}

std::uint32_t PoolTables::take_index() {
  if (free_.empty() && places_.size() < max_indices_) add_indices_up_to(places_.size() + places_per_slab);
  if (free_.empty()) {
    free_.swap(worn_);
    std::ranges::reverse(free_);  // the index that was worn first begins first
  }
  assert(!free_.empty() && "more living blocks than a pool has indices");
  const std::uint32_t index = free_.back();
  free_.pop_back();
  return index;
}

std::uint32_t PoolTables::bind() {
  const std::uint32_t place = first_hole(no_hole_below_);
  assert(place < place_count());
  const std::uint32_t index = take_index();
  places_[index] = place;
  owners_[place] = index;
  ++alive_in_slab_[place / places_per_slab];
  ++alive_count_;
  no_hole_below_ = place + 1;
  return index;
}

void PoolTables::unbind(std::uint32_t index) {
  const std::uint32_t place = std::exchange(places_[index], none);
  owners_[place] = none;
  --alive_in_slab_[place / places_per_slab];
  --alive_count_;
  no_hole_below_ = std::min(no_hole_below_, place);
  generations_[index] = static_cast<std::uint8_t>((generations_[index] + 1U) % lives_of_an_index);
  const bool worn = generations_[index] == 0;
  (worn ? worn_ : free_).push_back(index);
}

std::uint32_t PoolTables::first_hole(std::uint32_t from) const {
  while (from < place_count() && owners_[from] != none) {
    const std::uint32_t slab = from / places_per_slab;
    from = alive_in_slab_[slab] == places_per_slab ? (slab + 1) * places_per_slab : from + 1;
  }
  return from;
}

std::uint32_t PoolTables::first_owned(std::uint32_t from) const {
  while (from < place_count() && owners_[from] == none) {
    const std::uint32_t slab = from / places_per_slab;
    from = alive_in_slab_[slab] == 0 ? (slab + 1) * places_per_slab : from + 1;
  }
  return from;
}

void PoolTables::add_slab() {
  owners_.resize(owners_.size() + places_per_slab, none);
  alive_in_slab_.push_back(0);
  add_indices_up_to(owners_.size());
}

void PoolTables::add_indices_up_to(std::size_t count) {
  const std::size_t first = places_.size();
  const std::size_t end = std::min<std::size_t>(count, max_indices_);
  if (end <= first) return;
  places_.resize(end, none);
  generations_.resize(end, 0);
  free_.reserve(places_.capacity());
  worn_.reserve(places_.capacity());
  free_.insert(free_.begin(), end - first, none);
  for (std::size_t i = 0; i < end - first; ++i) free_[i] = static_cast<std::uint32_t>(end - 1 - i);
}

std::size_t PoolTables::bytes() const {
  const std::size_t words = places_.capacity() + owners_.capacity() + free_.capacity() + worn_.capacity();
  return words * sizeof(std::uint32_t) + generations_.capacity() + alive_in_slab_.capacity() * sizeof(std::uint16_t);
}

}  // namespace throng::anim
