#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Weight of a bone and all below it.
struct SubtreeWeight {
  int bone = 0;
  float weight = 1.0F;  ///< 0 to 1
};

/// Per-bone weights for blenders (paper 2.2.4), laid out as poses are: float [packet][16], 64-byte aligned. Lanes above
/// the bone count weigh 0.
class BoneMask {
 public:
  /// Every bone weighs `elsewhere`, but for the subtrees; a subtree inside another one wins, whatever their order.
  BoneMask(std::string name, const Skeleton& skeleton, std::span<const SubtreeWeight> subtrees, float elsewhere = 0.0F);

  const std::string& name() const { return name_; }
  int packets() const { return packets_; }
  /// Sixteen weights.
  const float* packet(int index) const;
  float weight(int bone) const;

 private:
  std::string name_;
  int packets_;
  AlignedBytes weights_;
};

/// Index of the bone of that name, or -1.
int find_bone(const Skeleton& skeleton, std::string_view name);

}  // namespace throng::anim
