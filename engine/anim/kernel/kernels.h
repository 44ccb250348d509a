#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/base/transform.h"
#include "engine/anim/kernel/hierarchy.h"
#include "engine/anim/kernel/noise.h"
#include "engine/anim/kernel/offset.h"
#include "engine/anim/kernel/packed_palette.h"
#include "engine/anim/kernel/pose.h"

namespace throng::anim {

struct FootPlacementJob;
struct LookAtJob;
struct TwoBoneIkJob;

inline constexpr int widest_strip = 16;  ///< characters

/// Pure functions over shaped spans: across bones up to the local pose, across characters from
/// there. Inside: no allocation, no lock, no global. All pointers are 64-byte aligned unless said.

/// Sample: 16 bones of one character at one time. Rotations come out unit.
struct SampleJob {
  const SampledStream* stream = nullptr;
  SamplePoint point;
  int packet = 0;         ///< 0 to stream->packet_count() - 1
  float* pose = nullptr;  ///< out, [components][16]
};

/// Pose clips: one packet of characters of a strip straight from their clips, one or a blend of two, to the bit what
/// SampleJob and then BlendJob give.
struct ClipMoment {
  const SampledStream* stream = nullptr;
  SamplePoint point;
};
struct ShownClips {
  const ClipMoment* clip = nullptr;     ///< null: something else
  const ClipMoment* blended = nullptr;  ///< onto it; or null
  float fraction = 0.0F;                ///< of `blended`, above 0 and below 1
};
struct PoseClipsJob {
  std::span<const ShownClips> characters;  ///< at most widest_strip; those that show something else are not touched
  int packet = 0;
  int components = rigid_components;
  QuadMask displaced = all_quads;  ///< on rigid skeletons: positions of others are 0, neither read nor written
  float* local = nullptr;          ///< out, [character][components][16]
};

/// Blend: out = normalise(from * (1 - w) + (to on from's hemisphere) * w), w = fraction * bone weight; positions and
/// scales linear. Under bone weights, a bone of w = 0 keeps the bits of `from` and one of w = 1 takes those of `to`.
/// `out` may be `from` or `to`.
struct BlendJob {
  const float* from = nullptr;          ///< [components][16]
  const float* to = nullptr;            ///< [components][16]
  const float* bone_weights = nullptr;  ///< [16], 0 to 1, or null: all 1
  float fraction = 0.0F;                ///< 0 to 1
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};

/// Mix: N sources at once, out = normalise(sum of w * q) in their order, each q on the hemisphere of the sum before it;
/// positions and scales linear. w = weight * bone weight, under bone weights divided by their sum bone by bone. A
/// source of w = 0 changes no bit; where one source weighs all its bits are copied, and where none weighs anything
/// those of the first whose `weight` is not 0 (else of the first). `out` may be any of the sources.
inline constexpr int most_mixed_sources = 8;
inline constexpr float least_mixed_weight = 1e-30F;  ///< a bone whose weights sum to less is weighed by none
struct MixJob {
  const float* const* sources = nullptr;       ///< [count], each [components][16]
  const float* weights = nullptr;              ///< [count], 0 or more, their sum is 1
  const float* const* bone_weights = nullptr;  ///< [count], each [16] from 0 to 1 or null (all 1); or null: all null
  int count = 0;                               ///< 1 to most_mixed_sources
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};

/// Add: an additive layer, applied on the right. Rotation base * normalise(identity * (1 - w) + delta * w), delta on
/// identity's hemisphere; position base + w * delta; scale base * (1 + w * (delta - 1)); w = weight * bone weight. A
/// bone of w = 0 keeps the bits of `base`. `out` may be `base` or `delta`.
struct AddJob {
  const float* base = nullptr;          ///< [components][16]
  const float* delta = nullptr;         ///< [components][16], see SubtractJob
  const float* bone_weights = nullptr;  ///< [16], 0 to 1, or null: all 1
  float weight = 0.0F;                  ///< 0 to 1
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};

/// Subtract: the delta that AddJob adds. Rotation reference^-1 * pose, with w >= 0; position pose - reference; scale
/// pose / reference, and 1 where the reference is 0. Added to the reference with a weight of 1 it gives the pose, its
/// rotation up to the sign. `out` may be `pose` or `reference`.
struct SubtractJob {
  const float* pose = nullptr;       ///< [components][16]
  const float* reference = nullptr;  ///< [components][16]
  int components = rigid_components;
  float* out = nullptr;  ///< [components][16]
};

/// How palettes are written; the values are the same. Which is fastest depends on how much is written in all, and on
/// the machine.
enum class StorePolicy : std::uint8_t {
  plain,
  prefetched,  ///< lines are fetched for writing while they are computed
  streaming    ///< past the caches, where palettes are 64-byte aligned; not visible to others before fence_stores()
};

/// Model space and palette of one packet of `width` characters of one skeleton. Packets are done in order, 0 first;
/// between them `carry` holds the last bone's transform.
inline constexpr int branch_slot_floats = 12;  ///< a lane's floats in `carry` and in each branch slot, at most
struct ModelPaletteJob {
  const HierarchyProgram* hierarchy = nullptr;
  int packet = 0;
  int bone_count = 0;              ///< of the level: bones at and above it are not touched
  int width = widest_strip;        ///< 1, 2, 4, 8 or 16
  int characters = widest_strip;   ///< 1 to width; further lanes are computed from garbage-free input, not written
  const float* local = nullptr;    ///< [width][components][16]
  QuadMask displaced = all_quads;  ///< on rigid skeletons: positions of others are 0, and are not read
  StorePolicy stores = StorePolicy::prefetched;
  float* carry = nullptr;                          ///< in and out, [branch_slot_floats][width]
  float* branch_slots = nullptr;                   ///< in and out, [slot_count][branch_slot_floats][width]
  PaletteFormat format = PaletteFormat::matrices;  ///< packed: where the hierarchy `packs`
  const PaletteDestination* palettes =
      nullptr;                      ///< [characters], 16-byte aligned; the kernel writes entries in ascending
                                    ///< order, whole cache lines where it can, and never reads them
  std::uint64_t* hashes = nullptr;  ///< [characters] or null: adds each written entry's hash, see palette_hash.h
};

/// Whole cache lines of one value and nothing else, in order: the floor under every kernel that writes palettes, and
/// the probe that tells how palettes are best written (run/store_choice.h).
struct WriteLinesJob {
  std::span<float> lines;  ///< out, [16 * lines]
  float value = 0.0F;
  StorePolicy stores = StorePolicy::plain;
};

/// Copies blocks between anywhere and places in a row. Sizes, in bytes, are multiples of 64. Guarded memory may be
/// copied (base/guard.h).
struct CopyBlocksJob {
  std::span<std::byte* const> blocks;  ///< anywhere
  std::byte* local = nullptr;          ///< in a row: the first
  std::size_t stride = 0;              ///< from one to the next in the row
  std::size_t offset = 0;              ///< into each of `blocks`
  std::size_t size = 0;                ///< from there on
  bool inward = true;                  ///< to the row
};

/// One SIMD target's set.
struct Kernels {
  const char* target;  ///< as Highway names it: "AVX3", "AVX2", "SSE4", ..., "SCALAR"
  bool fused_multiply_add;
  void (*sample)(const SampleJob& job);
  void (*pose_clips)(const PoseClipsJob& job);
  void (*blend)(const BlendJob& job);
  void (*mix)(const MixJob& job);
  void (*add)(const AddJob& job);
  void (*subtract)(const SubtractJob& job);
  void (*capture_offset)(const OffsetCaptureJob& job);
  void (*apply_offset)(const OffsetApplyJob& job);
  void (*noise)(const NoiseJob& job);
  void (*look_at)(std::span<const LookAtJob> jobs);  ///< at most widest_strip, all of one rig; see look_at.h
  void (*two_bone_ik)(std::span<const TwoBoneIkJob> jobs, float* missed_by);  ///< of one limb; missed_by [jobs.size()]
  void (*place_feet)(std::span<const FootPlacementJob> jobs);                 ///< of one rig; see foot_placement.h
  void (*model_palette)(const ModelPaletteJob& job);
  void (*write_lines)(const WriteLinesJob& job);
  void (*copy_blocks)(const CopyBlocksJob& job);
  void (*fence_stores)();  ///< what was streamed is visible to whoever learns of it from now on
};

/// The best that this machine runs; all that it runs, best first; and the scalar target (same algorithm).
const Kernels& best_kernels();
std::span<const Kernels> runnable_kernels();
const Kernels& scalar_kernels();

}  // namespace throng::anim
