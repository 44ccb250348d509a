#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/anim/agent/agents.h"
#include "engine/anim/base/pool.h"

namespace throng::anim {

/// Owned by the caller and used again and again; opaque.
class SystemSnapshot {
 public:
  std::size_t bytes() const;

 private:
  friend class AnimationSystem;

  std::vector<PoolSnapshot> pools_;  // own and shared of each kind, in turns
  std::optional<Agents> agents_;
  std::optional<Agents> shared_;
  Ticks clock_ = 0;
  std::uint64_t frame_ = 0;
  std::uint64_t pose_hash_ = 0;
  std::vector<Ticks> posed_at_;
  Ticks shared_posed_at_ = 0;
  std::vector<std::uint64_t> agent_hashes_;
};

}  // namespace throng::anim
