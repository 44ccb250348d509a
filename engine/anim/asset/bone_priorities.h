#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// The paper's first way of per-bone level of detail (3.2), with a priority of its own for every bone: what a player
/// evaluates of a pose. The second way, an order of bones whose prefixes are levels, is Skeleton::level_bone_counts.
///
/// A bone that is not evaluated is still: on rigid skeletons it follows its nearest evaluated ancestor as if bound to
/// it, on others it keeps its rest transform. Evaluated bones below it go on moving.
class BoneSelection {
 public:
  /// Bones whose priority is at least `least`; `priorities` has one a bone.
  BoneSelection(const Skeleton& skeleton, std::span<const std::uint8_t> priorities, std::uint8_t least);

  int packets() const { return static_cast<int>(lanes_.size()); }
  /// A bit for each bone of the packet that is evaluated, bone 0 lowest. 0: the packet can be skipped. Lanes above the
  /// bone count go with the packet, so that one whose bones are all evaluated has all bits.
  std::uint16_t lanes(int packet) const { return lanes_[static_cast<std::size_t>(packet)]; }
  /// What bones show that are not evaluated: float [components][16], 64-byte aligned.
  const float* still(int packet) const;
  int components() const { return components_; }
  int evaluated_bones() const { return evaluated_bones_; }

 private:
  int components_;
  int evaluated_bones_ = 0;
  std::vector<std::uint16_t> lanes_;
  AlignedBytes still_;
};

/// Makes the bones of one packet still that are not selected; the others keep their bits. `pose` is [components][16].
void apply_bone_priorities(const BoneSelection& bones, int packet, float* pose);

}  // namespace throng::anim
