#include <cstring>
#include <string>

#include "engine/anim/base/pool.h"

namespace throng::anim {

void Pool::snapshot(PoolSnapshot& into) const {
  if (into.block_size_ != block_size_) into.slabs_.clear();
  into.pool_ = id_;
  into.block_size_ = block_size_;
  into.tables_.copy_from(tables_);
  std::size_t copied = 0;
  for (std::size_t slab = 0; slab < slabs_.size(); ++slab) {
    if (tables_.alive_in_slab(slab) == 0) continue;
    if (copied == into.slabs_.size()) into.slabs_.push_back(allocate_aligned(slab_bytes()));
    std::memcpy(into.slabs_[copied++].get(), slabs_[slab], slab_bytes());
  }
}

Status Pool::restore(const PoolSnapshot& from) {
  const std::string name = "pool " + std::to_string(id_);
  if (from.pool_ == Handle::none) return Error{name + ": the snapshot is empty; take one before it is restored"};
  if (from.pool_ != id_) {
    return Error{name + ": the snapshot is of pool " + std::to_string(from.pool_) + "; restore it there"};
  }
  if (from.block_size_ != block_size_) {
    return Error{name + ": the snapshot's blocks have " + std::to_string(from.block_size_) + " bytes, the pool's " +
                 std::to_string(block_size_) + "; restore under the residency that it was taken under"};
  }
  tables_.copy_from(from.tables_);
  grow_to(tables_.slab_count());
  std::size_t copied = 0;
  for (std::size_t slab = 0; slab < tables_.slab_count(); ++slab) {
    if (tables_.alive_in_slab(slab) == 0) continue;
    std::memcpy(slabs_[slab], from.slabs_[copied++].get(), slab_bytes());
  }
  while (tables_.slab_count() < slabs_.size()) tables_.add_slab();
  return Done{};
}

}  // namespace throng::anim
