#pragma once

#include <cstddef>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim {

/// The state of a system at a moment. The caller owns it and can use it again and again. Only AnimationSystem reads it.
class SystemSnapshot {
 public:
  std::size_t bytes() const { return population_.bytes() + hashes_.bytes(); }

 private:
  friend class AnimationSystem;

  PopulationSnapshot population_;
  FrameHashes hashes_;
};

}  // namespace throng::anim
