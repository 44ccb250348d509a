#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/kernel_rig.h"

/// Palettes of those skeletons by the kernels.
namespace throng::anim::kernel_rig {

/// The request for the palettes that are computed.
struct PaletteRequest {
  StorePolicy stores = StorePolicy::prefetched;
  QuadMask displaced = all_quads;
  bool hashed = true;
  bool whole_lines = false;  ///< true: all palettes begin a cache line; false: every second one is only 16-byte aligned
  const JointProgram* joints = nullptr;  ///< joints that are written on the way
};

/// The requests of frames for rigid skeletons, few of whose bones are displaced.
inline constexpr PaletteRequest usual_requests[] = {
    {.stores = StorePolicy::plain, .displaced = 0, .hashed = false, .whole_lines = true},
    {.stores = StorePolicy::prefetched, .displaced = 0, .hashed = false, .whole_lines = true},
    {.stores = StorePolicy::streaming, .displaced = 0, .hashed = false, .whole_lines = true},
    {.stores = StorePolicy::prefetched, .displaced = 0b0001, .hashed = false, .whole_lines = true},
    {.stores = StorePolicy::streaming, .displaced = 0b1010, .hashed = false, .whole_lines = true},
    {.stores = StorePolicy::prefetched, .displaced = 0b0100, .hashed = true, .whole_lines = true}};

/// The palettes and hashes of characters, computed in strips of `width`. The last strip may be partly filled. Every
/// palette lies between guard bytes, and so do entries of bones above `bone_count`.
template <typename Entry>
struct CrowdResultOf {
  std::vector<std::vector<Entry>> palettes;  ///< [character][entry below the bone count]
  std::vector<std::uint64_t> hashes;
  std::vector<std::vector<float>> joints;  ///< [character], of the request
  bool guards_intact = true;
};
using CrowdResult = CrowdResultOf<PaletteMatrix>;
using PackedCrowdResult = CrowdResultOf<PackedPaletteEntry>;
CrowdResult compute_palettes(const Kernels& kernels, const HierarchyProgram& program,
                             const std::vector<StatePose>& characters, int width, int bone_count,
                             const PaletteRequest& request = {});

PackedCrowdResult compute_packed_palettes(const Kernels& kernels, const HierarchyProgram& program,
                                          const std::vector<StatePose>& characters, int width, int bone_count,
                                          const PaletteRequest& request = {});

bool same_bits(const std::vector<PackedPaletteEntry>& a, const std::vector<PackedPaletteEntry>& b);
bool same_bits(const std::vector<PaletteMatrix>& a, const std::vector<PaletteMatrix>& b);

}  // namespace throng::anim::kernel_rig
