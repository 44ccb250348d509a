#include "engine/anim/agent/system_snapshot.h"

#include <algorithm>

namespace throng::anim {

std::size_t SystemSnapshot::bytes() const {
  std::size_t bytes = posed_at_.size() * (sizeof(Ticks) + sizeof(std::uint64_t));
  for (const CastSnapshot& cast : casts_) bytes += cast.bytes();
  return bytes;
}

void AnimationSystem::snapshot(SystemSnapshot& into) const {
  into.casts_.resize(casts_.size());
  for (std::size_t i = 0; i < casts_.size(); ++i) casts_[i]->snapshot(into.casts_[i]);
  into.members_ = members_;
  into.clock_ = clock_;
  into.frame_ = frame_;
  into.pose_hash_ = pose_hash_;
  into.posed_at_ = posed_at_;
  into.shared_posed_at_ = shared_posed_at_;
  into.agent_hashes_ = agent_hashes_;
}

Status AnimationSystem::restore(const SystemSnapshot& from) {
  if (from.casts_.empty()) return Error{"there is no crowd in this snapshot: take one first"};
  if (from.casts_.size() != casts_.size()) {
    return Error{"characters were added since this snapshot: take another one"};
  }
  LocalStoreDemand needs = demand(options_);
  for (std::size_t i = 0; i < casts_.size(); ++i) {
    const CastSnapshot& cast = from.casts_[i];
    if (cast.pools.size() != std::size_t{2} * casts_[i]->pools.kind_count()) {
      return Error{"kinds of entities were added since this snapshot: take another one"};
    }
    if (cast.character != casts_[i]->character) {
      return Error{"the bones of \"" + casts_[i]->skeleton().name +
                   "\" are in another order since this snapshot: take another one"};
    }
    needs.largest.widen(cast.agents->largest_needs());
    needs.shared_entity_bytes =
        std::max<std::size_t>(needs.shared_entity_bytes, cast.shared->largest_needs().entity_bytes);
  }
  if (Status fits = fit_stores(needs); !fits) return fits;
  for (std::size_t i = 0; i < casts_.size(); ++i) {
    if (Status restored = casts_[i]->restore(from.casts_[i]); !restored) return restored;
  }
  members_ = from.members_;
  clock_ = from.clock_;
  frame_ = from.frame_;
  pose_hash_ = from.pose_hash_;
  shared_posed_at_ = from.shared_posed_at_;
  posed_at_ = from.posed_at_;
  agent_hashes_ = from.agent_hashes_;
  reserve_work();
  return Done{};
}

Compaction AnimationSystem::compact() {
  Compaction all{.complete = true};
  for (const std::unique_ptr<Cast>& cast : casts_) {
    const Compaction one = cast->compact();
    all.blocks_moved += one.blocks_moved;
    all.bytes_given_back += one.bytes_given_back;
  }
  return all;
}

}  // namespace throng::anim
