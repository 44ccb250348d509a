#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/surface.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// Poses the surface of a model at a time of one of its clips straight from the definition, without its root motion.
inline std::vector<BoneFrame> frames_by_definition(const Model& model, const Clip& clip, double seconds) {
  const ReferencePose pose = reference_pose(model.skeleton, &clip, seconds);
  std::vector<BoneFrame> frames(model.skeleton.bones.size());
  for (std::size_t bone = 0; bone < frames.size(); ++bone) {
    frames[bone] = {.axes = glm::dmat3(pose.globals[bone]), .origin = glm::dvec3(pose.globals[bone][3])};
    if (!model.skeleton.rigid) continue;
    const ReferenceFrame& reference = model.skeleton.references[bone];
    frames[bone].axes *= glm::mat3_cast(glm::conjugate(reference.rotation)) / reference.scale;
  }
  return frames;
}

inline BoneFrame moved_frame(const RootMotion& motion, const BoneFrame& frame) {
  const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(motion.yaw, glm::dvec3(0.0, 1.0, 0.0)));
  return motion.yaw == 0.0 ? BoneFrame{.axes = frame.axes, .origin = frame.origin + motion.translation}
                           : BoneFrame{.axes = turn * frame.axes, .origin = turn * frame.origin + motion.translation};
}

/// Returns how far the stream that a clip plays from is off the definition at most, in metres on the surface, at
/// `times` even times from its first key to its last.
inline double error_by_definition(const Model& model, const Clip& clip, const BakedClip& baked, int times) {
  const SurfaceProxy proxy = make_surface_proxy(model);
  const std::size_t bytes = pose_bytes(model.skeleton.bone_count(), model.skeleton.components());
  const AlignedBytes block = allocate_aligned(bytes);
  const std::span pose(reinterpret_cast<float*>(block.get()), bytes / sizeof(float));
  const std::size_t packet_floats = static_cast<std::size_t>(model.skeleton.components()) * packet_bones;
  std::vector<BoneFrame> shown(model.skeleton.bones.size());
  ExactPoses keys(*baked.keyframe());
  double worst = 0.0;
  for (int i = 0; i <= times; ++i) {
    const Ticks time = baked.duration * i / times;
    if (const SampledStream* const stream = baked.sampled()) {
      for (int packet = 0; packet < stream->packet_count(); ++packet) {
        float* const out = pose.data() + static_cast<std::size_t>(packet) * packet_floats;
        scalar_kernels().sample({.stream = stream, .point = locate(*stream, time), .packet = packet, .pose = out});
      }
    } else {
      std::ranges::copy(keys.at(time), pose.begin());
    }
    compute_frames(model.skeleton, pose, shown);
    const RootMotion moved = displacement(baked.root_motion, 0, time * fine_ticks_per_tick, false);
    for (BoneFrame& frame : shown) frame = moved_frame(moved, frame);
    const auto expected = frames_by_definition(model, clip, clip.start + to_seconds(time));
    worst = std::max(worst, largest_distance(proxy, expected, shown));
  }
  return worst;
}

}  // namespace throng::anim
