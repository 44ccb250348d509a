#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// The weight of a bone and of all bones below it.
struct SubtreeWeight {
  int bone = 0;
  float weight = 1.0F;  ///< 0 to 1
};

/// Holds a weight a bone for blenders (paper 2.2.4), laid out like a pose: float [packet][16], 64-byte aligned. Lanes
/// from the bone count on weigh 0.
class BoneMask {
 public:
  /// Gives every bone the weight `elsewhere`, except in the subtrees. An inner subtree wins over an outer one, in any
  /// order.
  BoneMask(std::string name, const Skeleton& skeleton, std::span<const SubtreeWeight> subtrees, float elsewhere = 0.0F);

  const std::string& name() const { return name_; }
  int packets() const { return packets_; }
  /// Returns sixteen weights.
  const float* packet(int index) const;
  float weight(int bone) const;

 private:
  std::string name_;
  int packets_;
  AlignedBytes weights_;
};

/// Returns the index of the bone of that name, or -1.
int find_bone(const Skeleton& skeleton, std::string_view name);

}  // namespace throng::anim
