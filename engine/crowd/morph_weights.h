#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/lod/lod.h"

namespace throng {

/// The weights that the morphs of some agents in a picture have now. Agents without morphs cost nothing, nor do agents
/// too small on screen to show any. Memory is kept from frame to frame.
class MorphWeights {
 public:
  void clear() { weights_.clear(); }

  /// Adds the weights of an agent in view, which has this character. Returns 1 + the number of its first one; 0 where
  /// it has none.
  std::uint32_t add(const anim::AnimationSystem& system, const anim::Character& character,
                    const anim::VisibleAgent& agent);

  std::span<const float> all() const { return weights_; }

 private:
  std::vector<float> weights_;
};

}  // namespace throng
