#include "engine/anim/agent/system_snapshot.h"

#include <algorithm>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

std::size_t SystemSnapshot::bytes() const {
  std::size_t bytes = posed_at_.size() * (sizeof(Ticks) + sizeof(std::uint64_t));
  for (const PoolSnapshot& pool : pools_) bytes += pool.bytes();
  return agents_ ? bytes + agents_->bytes() : bytes;
}

void AnimationSystem::snapshot(SystemSnapshot& into) const {
  into.pools_.resize(std::size_t{2} * pools_.kind_count());
  for (EntityPools::Kind kind = 0; kind < pools_.kind_count(); ++kind) {
    pools_.pool(kind).snapshot(into.pools_[2 * kind]);
    pools_.shared_pool(kind).snapshot(into.pools_[2 * kind + 1]);
  }
  into.agents_.emplace(agents_.clone());
  into.shared_.emplace(shared_.clone());
  into.clock_ = clock_;
  into.frame_ = frame_;
  into.pose_hash_ = pose_hash_;
  into.posed_at_ = posed_at_;
  into.shared_posed_at_ = shared_posed_at_;
  into.agent_hashes_ = agent_hashes_;
}

Status AnimationSystem::restore(const SystemSnapshot& from) {
  if (!from.agents_) return Error{"there is no crowd in this snapshot: take one first"};
  if (from.pools_.size() != std::size_t{2} * pools_.kind_count()) {
    return Error{"kinds of entities were added since this snapshot: take another one"};
  }
  LocalStoreDemand needs = demand(options_);
  needs.largest.widen(from.agents_->largest_needs());
  needs.shared_entity_bytes =
      std::max<std::size_t>(needs.shared_entity_bytes, from.shared_->largest_needs().entity_bytes);
  if (Status fits = fit_stores(needs); !fits) return fits;
  for (EntityPools::Kind kind = 0; kind < pools_.kind_count(); ++kind) {
    // The first is refused if any is: all are of one residency.
    if (Status restored = pools_.pool(kind).restore(from.pools_[2 * kind]); !restored) return restored;
    if (Status restored = pools_.shared_pool(kind).restore(from.pools_[2 * kind + 1]); !restored) return restored;
  }
  agents_ = from.agents_->clone();
  shared_ = from.shared_->clone();
  clock_ = from.clock_;
  frame_ = from.frame_;
  pose_hash_ = from.pose_hash_;
  posed_at_ = from.posed_at_;
  shared_posed_at_ = from.shared_posed_at_;
  agent_hashes_ = from.agent_hashes_;
  work_.reserve(agent_count());
  scheduler_->reserve(agent_count());
  return Done{};
}

Compaction AnimationSystem::compact() {
  std::vector<Handle> order;
  for (const Agents* graphs : {&shared_, &agents_}) {
    for (std::uint32_t agent = 0; agent < graphs->count(); ++agent) {
      for (const PoseStep& step : graphs->program(agent).steps) order.push_back(step.entity);
    }
  }
  Compaction all{.complete = true};
  for (EntityPools::Kind kind = 0; kind < pools_.kind_count(); ++kind) {
    for (Pool* pool : {&pools_.pool(kind), &pools_.shared_pool(kind)}) {
      const Compaction one = pool->compact(order);
      all.blocks_moved += one.blocks_moved;
      all.bytes_given_back += one.bytes_given_back;
    }
  }
  return all;
}

}  // namespace throng::anim
