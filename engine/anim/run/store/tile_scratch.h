#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Carves typed spans out of a part of the local store, front to back, each on its own cache line.
class ScratchCarver {
 public:
  explicit ScratchCarver(std::span<std::byte> memory) : memory_(memory) {}

  template <typename T>
  std::span<T> carve(std::size_t count) {
    const std::size_t bytes = (count * sizeof(T) + 63) / 64 * 64;
    T* const first = memory_.empty() ? nullptr : reinterpret_cast<T*>(memory_.subspan(used_, bytes).data());
    used_ += bytes;
    return {first, first == nullptr ? 0 : count};
  }
  std::size_t used() const { return used_; }

 private:
  std::span<std::byte> memory_;
  std::size_t used_ = 0;
};

/// The scratch of the last step of a strip of `width` characters. The kernels of hierarchy and palettes run across
/// them.
///
///     local     float [width][components][16]              one packet of each character's local pose
///     carry     float [branch_slot_floats][width]          the last bone's transform
///     branches  float [slots][branch_slot_floats][width]   transforms of branch points
///     palettes, hashes                                     the destinations of each character
///     joint_carry, joint_branches, joints                  as above for lists of joints; lists beside matrices share
///                                                          the first two, as one walk does both
struct ModelScratch {
  std::span<float> local;
  std::span<float> carry;
  std::span<float> branches;
  std::span<PaletteDestination> palettes;
  std::span<std::uint64_t> hashes;
  std::span<float> joint_carry;
  std::span<float> joint_branches;
  std::span<float*> joints;

  /// Carves the scratch. `with_local` is false if the local poses lie in a fetch buffer.
  static ModelScratch carve(ScratchCarver& carver, int width, const UpdateContext& context, bool with_local);
};

}  // namespace throng::anim
