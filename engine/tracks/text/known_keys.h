#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "engine/tracks/text/table_layout.h"

namespace throng {

/// Says what the keys of JSON mean, by the names that columns of tables may have. It keeps what a key means, for the
/// same few keys come in every object.
class KnownKeys {
 public:
  struct Key {
    TableColumn column;
    std::size_t rank = 0;  ///< rank_of() the column: of an object's keys for one field, the least rank counts
  };
  static constexpr std::size_t no_rank = std::numeric_limits<std::size_t>::max();

  /// The reference is good until the next call.
  const Key& of(std::string_view name) {
    const auto is_it = [&](const Key& key) { return key.column.name == name; };
    const auto found = std::ranges::find_if(keys_, is_it);
    if (found != keys_.end()) return *found;
    if (keys_.size() == most_keys) keys_.pop_back();
    TableColumn column = column_named(name);
    const std::size_t rank = std::min(rank_of(column), no_rank - 1);
    keys_.push_back({std::move(column), rank});  // emplace_back() of an aggregate needs clang 16
    return keys_.back();
  }
  /// Returns the keys that came so far, at most 64.
  std::span<const Key> all() const { return keys_; }

 private:
  static constexpr std::size_t most_keys = 64;
  std::vector<Key> keys_;
};

/// The ranks of the keys that an object has, by field.
class FieldRanks {
 public:
  FieldRanks() { ranks_.fill(KnownKeys::no_rank); }

  /// Returns whether a key counts for its field beside the keys before it. Of a key that comes twice the last counts.
  bool takes(const KnownKeys::Key& key) {
    std::size_t& rank = ranks_[static_cast<std::size_t>(key.column.field)];
    if (key.column.field == TrackField::none || key.rank > rank) return false;
    rank = key.rank;
    return true;
  }
  bool has(TrackField field) const { return ranks_[static_cast<std::size_t>(field)] != KnownKeys::no_rank; }

 private:
  std::array<std::size_t, track_field_count> ranks_;
};

}  // namespace throng
