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

/// Of one tile; each as wide as kernels work side by side.
inline constexpr int most_strips = 2;
inline constexpr int most_characters = most_strips * widest_strip;

/// What a PU is handed: agents of one skeleton and bone level, all held or all streaming. They come into its store
/// together, and are posed strip by strip.
struct Tile {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t width = widest_strip;    ///< characters of a strip
  float cost = 0;                        ///< predicted, nanoseconds
  const PoseProgram* program = nullptr;  ///< of all of them; null: several
  StoreNeeds needs = {};                 ///< the widest of its agents

  std::uint32_t strips() const { return (count + width - 1) / width; }
};

/// Scratch of the model-palette step of a strip of `width` characters; hierarchy and palette run across them.
///
///     local     float [width][components][16]              one packet of each character's local pose
///     carry     float [branch_slot_floats][width]          the last bone's transform
///     branches  float [slots][branch_slot_floats][width]   transforms of branch points
///     palettes, hashes                                     where each character's go
struct ModelScratch {
  std::span<float> local;
  std::span<float> carry;
  std::span<float> branches;
  std::span<PaletteDestination> palettes;
  std::span<std::uint64_t> hashes;

  /// `with_local`: false where the local poses lie in a fetch buffer.
  static ModelScratch carve(ScratchCarver& carver, int width, int components, int slots, bool with_local);
};

}  // namespace throng::anim
