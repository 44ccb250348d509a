#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "engine/anim/entity/animation_state.h"
#include "engine/anim/kernel/pose/pose_view.h"

namespace throng::anim {

/// Moves and changes a block of any kind in the paper's three steps, at a frame boundary.
/// Paper 2.2.1: "Using total size and transforms offset the animation state can be moved around in memory and
/// manipulated without knowing the exact type of the structure and its use."
///
///     const std::optional<BlockReader> reader = BlockReader::fetch(block, local);   // 1. move total size bytes
///     reader->pose().set_rotation(bone, rotation);                                  // 2. read, update the transforms
///     reader->put_back(block);                                                      // 3. copy it back
class BlockReader {
 public:
  /// Copies the block to `local`, which is 64-byte aligned. Returns nothing if it is larger than `local`.
  static std::optional<BlockReader> fetch(const std::byte* block, std::span<std::byte> local);

  const AnimationStateHeader& state() const { return *state_; }
  std::span<const std::byte> bytes() const;
  bool has_transforms() const { return state_->transforms_offset != 0; }
  /// Returns the pose of a block that has transforms.
  PoseView pose() const;

  void put_back(std::byte* block) const;

 private:
  explicit BlockReader(AnimationStateHeader& state) : state_(&state) {}

  AnimationStateHeader* state_;
};

}  // namespace throng::anim
