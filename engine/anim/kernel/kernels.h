#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/anim/kernel/lanes/copy_blocks.h"
#include "engine/anim/kernel/palette/model_joints.h"
#include "engine/anim/kernel/palette/model_palette.h"
#include "engine/anim/kernel/palette/write_lines.h"
#include "engine/anim/kernel/pose/add.h"
#include "engine/anim/kernel/pose/blend.h"
#include "engine/anim/kernel/pose/mix.h"
#include "engine/anim/kernel/pose/noise.h"
#include "engine/anim/kernel/pose/offset.h"
#include "engine/anim/kernel/pose/pose_clips.h"
#include "engine/anim/kernel/pose/sample.h"
#include "engine/anim/kernel/pose/subtract.h"

namespace throng::anim {

struct FootPlacementJob;
struct LookAtJob;
struct TwoBoneIkJob;

/// Kernels are pure functions over plain arrays. They run across bones up to the local pose, and across characters from
/// there. They do not allocate, lock or read globals. Pointers are 64-byte aligned unless their job says otherwise.
/// Each job stands in the header of its kernel, with an `is_valid` that the kernel asserts.

/// The kernels of one SIMD target.
struct Kernels {
  const char* target;  ///< Highway's name of it: "AVX3", "AVX2", "SSE4", ..., "SCALAR"
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
  void (*model_joints)(const ModelJointsJob& job);
  void (*write_lines)(const WriteLinesJob& job);
  void (*copy_blocks)(const CopyBlocksJob& job);
  void (*fence_stores)();  ///< makes all streamed stores visible to other threads
};

/// Returns the kernels of the best target of this machine, or those that choose_kernels() was given.
const Kernels& best_kernels();
/// Returns the kernels of all targets that this machine runs, the best first.
std::span<const Kernels> runnable_kernels();
/// Returns Highway's names of all targets that this build has, the best first.
std::vector<std::string> compiled_targets();
/// Returns the kernels of the scalar target, which has the same algorithm.
const Kernels& scalar_kernels();

}  // namespace throng::anim
