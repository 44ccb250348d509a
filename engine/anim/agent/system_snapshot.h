#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// Owned by the caller and used again and again; opaque.
class SystemSnapshot {
 public:
  std::size_t bytes() const;

 private:
  friend class AnimationSystem;

  std::vector<CastSnapshot> casts_;
  std::vector<AnimationSystem::Member> members_;
  Ticks clock_ = 0;
  std::uint64_t frame_ = 0;
  std::uint64_t pose_hash_ = 0;
  Ticks shared_posed_at_ = 0;
  std::vector<Ticks> posed_at_;
  std::vector<std::uint64_t> agent_hashes_;
};

}  // namespace throng::anim
