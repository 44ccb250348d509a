#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Says which bones of a pose a player evaluates; every bone has a priority of its own. This is the paper's first way
/// of per-bone level of detail (3.2). The second way is an order of bones whose prefixes are levels
/// (Skeleton::level_bone_counts).
///
/// A bone that is not evaluated is still. On rigid skeletons it follows its nearest evaluated ancestor as if bound to
/// it; on others it keeps its rest transform. Evaluated bones below it go on moving.
class BoneSelection {
 public:
  /// Selects the bones whose priority is at least `least`; `priorities` has one a bone.
  BoneSelection(const Skeleton& skeleton, std::span<const std::uint8_t> priorities, std::uint8_t least);

  int packets() const { return static_cast<int>(lanes_.size()); }
  /// Returns a bit for each evaluated bone of the packet, the lowest bit for the first bone. 0: the packet can be
  /// skipped. Lanes without a bone are set when any bone of the packet is evaluated, so a full packet has all bits.
  std::uint16_t lanes(int packet) const { return lanes_[static_cast<std::size_t>(packet)]; }
  /// Returns the state of the bones that are not evaluated: float [components][16], 64-byte aligned.
  const float* still(int packet) const;
  int components() const { return components_; }

 private:
  int components_;
  std::vector<std::uint16_t> lanes_;
  AlignedBytes still_;
};

/// Makes the bones of one packet still that are not selected. The others keep their bits. `pose` is [components][16].
void apply_bone_priorities(const BoneSelection& bones, int packet, float* pose);

}  // namespace throng::anim
