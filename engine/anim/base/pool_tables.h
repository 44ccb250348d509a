#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace throng::anim {

/// The tables of a pool: the place of each index's block, the index that owns each place, and which of both are free. A
/// place is a block's number in the slabs.
///
/// An index lives 128 times, since a generation has 7 bits, and is then worn. New indices replace worn ones up to
/// `max_indices`. Only when each of those is alive or worn do worn ones begin again. The bits of a handle therefore
/// come back after some 128 * (max_indices - living blocks) creations.
class PoolTables {
 public:
  static constexpr std::uint32_t places_per_slab = 1024;
  static constexpr std::uint32_t none = UINT32_MAX;
  static constexpr std::uint32_t lives_of_an_index = 128;

  explicit PoolTables(std::uint32_t max_indices = 0) : max_indices_(max_indices) {}

  /// Makes these tables equal to `other`, with room for its growth, so that a second call in a row allocates nothing.
  void copy_from(const PoolTables& other);

  /// Returns the place of a living index, less than place_count().
  std::uint32_t place_of(std::uint32_t index) const { return places_[index]; }
  std::uint32_t generation_of(std::uint32_t index) const { return generations_[index]; }
  bool alive(std::uint32_t index, std::uint32_t generation) const;

  /// Binds a free index to the lowest hole and returns the index. There must be a hole.
  std::uint32_t bind();
  void unbind(std::uint32_t index);

  /// Returns the lowest place from `from` on that is owned; place_count() if there is none.
  std::uint32_t first_owned(std::uint32_t from) const;

  void add_slab();

  std::uint32_t alive_in_slab(std::size_t slab) const { return alive_in_slab_[slab]; }
  std::size_t slab_count() const { return alive_in_slab_.size(); }
  std::uint32_t place_count() const { return static_cast<std::uint32_t>(owners_.size()); }
  std::size_t alive_count() const { return alive_count_; }
  std::uint32_t max_indices() const { return max_indices_; }
  std::size_t bytes() const;

 private:
  std::uint32_t first_hole(std::uint32_t from) const;
  std::uint32_t take_index();
  void add_indices_up_to(std::size_t count);

  std::uint32_t max_indices_;
  std::vector<std::uint32_t> places_;      // [index] `none` while it is dead
  std::vector<std::uint8_t> generations_;  // [index] a handle of another generation is dead
  std::vector<std::uint32_t> free_;        // indices; the last one is taken next
  std::vector<std::uint32_t> worn_;        // indices, in the order in which they wore out
  std::vector<std::uint32_t> owners_;      // [place] an index
  std::vector<std::uint16_t> alive_in_slab_;
  std::uint32_t no_hole_below_ = 0;
  std::size_t alive_count_ = 0;
};

}  // namespace throng::anim
