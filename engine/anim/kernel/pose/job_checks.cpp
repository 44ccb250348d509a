#include "engine/anim/kernel/lanes/job_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/anim/kernel/pose/add.h"
#include "engine/anim/kernel/pose/blend.h"
#include "engine/anim/kernel/pose/mix.h"
#include "engine/anim/kernel/pose/noise.h"
#include "engine/anim/kernel/pose/offset.h"
#include "engine/anim/kernel/pose/pose_clips.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/anim/kernel/pose/sample.h"
#include "engine/anim/kernel/pose/subtract.h"

namespace throng::anim {
namespace {

constexpr std::size_t floats_of_offsets = std::size_t{offset_components} * packet_bones;
constexpr std::size_t captured_floats = std::size_t{rigid_components} * packet_bones;
constexpr std::size_t quad_alignment = quad_bones * sizeof(float);  // poses are tweaked by quads

bool is_point(const SamplePoint& point) {
  const std::int32_t fraction = -static_cast<std::int16_t>(point.weights >> 16U);
  const bool weighed = fraction >= 0 && fraction <= sample_fraction_one && point.weights == row_weights(fraction);
  return is_aligned(point.from) && is_aligned(point.to) && weighed;
}

bool is_packet_of(const SampledStream* stream, int packet) {
  return is_aligned(stream) && packet >= 0 && packet < stream->packet_count();
}

bool is_moment(const ClipMoment& moment, const PoseClipsJob& job) {
  return is_packet_of(moment.stream, job.packet) && moment.stream->components == job.components &&
         is_point(moment.point);
}

bool is_shown(const ShownClips& shown, const PoseClipsJob& job) {
  if (shown.clip == nullptr) return shown.blended == nullptr;
  if (!is_moment(*shown.clip, job)) return false;
  return shown.blended == nullptr || (is_moment(*shown.blended, job) && shown.fraction > 0.0F && shown.fraction < 1.0F);
}

bool is_moment(const NoiseMoment* moment) {
  return moment != nullptr && moment->amplitude >= 0.0F && moment->amplitude <= std::numbers::pi_v<float> &&
         std::ranges::all_of(moment->shares, is_not_negative);
}

bool are_weights(const MixJob& job) {
  float sum = 0.0F;
  for (int source = 0; source < job.count; ++source) {
    if (!is_not_negative(job.weights[source])) return false;
    sum += job.weights[source];
  }
  return sum == 0.0F || std::abs(sum - 1.0F) < most_mixed_excess;
}

}  // namespace

bool is_valid(const SampleJob& job) {
  return is_packet_of(job.stream, job.packet) && is_component_count(job.stream->components) && is_point(job.point) &&
         is_aligned(job.pose);
}

bool is_valid(const PoseClipsJob& job) {
  return job.characters.size() <= std::size_t{widest_strip} && job.packet >= 0 && is_component_count(job.components) &&
         job.displaced <= all_quads && is_aligned(job.local) &&
         std::ranges::all_of(job.characters, [&](const ShownClips& shown) { return is_shown(shown, job); });
}

bool is_valid(const BlendJob& job) {
  return is_aligned(job.from) && is_aligned(job.to) && is_aligned(job.out) && are_bone_weights(job.bone_weights) &&
         is_share(job.fraction) && is_component_count(job.components);
}

bool is_valid(const MixJob& job) {
  if (job.count < 1 || job.count > most_mixed_sources || job.sources == nullptr || job.weights == nullptr) return false;
  for (int source = 0; source < job.count; ++source) {
    if (!is_aligned(job.sources[source])) return false;
    if (job.bone_weights != nullptr && !are_bone_weights(job.bone_weights[source])) return false;
  }
  return are_weights(job) && is_component_count(job.components) && is_aligned(job.out);
}

bool is_valid(const AddJob& job) {
  return is_aligned(job.base) && is_aligned(job.delta) && is_aligned(job.out) && are_bone_weights(job.bone_weights) &&
         is_share(job.weight) && is_component_count(job.components);
}

bool is_valid(const SubtractJob& job) {
  return is_aligned(job.pose) && is_aligned(job.reference) && is_aligned(job.out) && is_component_count(job.components);
}

bool is_valid(const OffsetCaptureJob& job) {
  if (!is_aligned(job.shown) || !is_aligned(job.target)) return false;
  if (!is_null_or_aligned(job.shown_before) || !is_null_or_aligned(job.target_before)) return false;
  if (!is_aligned(job.offsets) || !is_aligned(job.velocities) || !std::isfinite(job.seconds_between)) return false;
  for (const float* const input : {job.shown, job.shown_before, job.target, job.target_before}) {
    if (!are_apart(job.offsets, floats_of_offsets, input, captured_floats)) return false;
    if (!are_apart(job.velocities, floats_of_offsets, input, captured_floats)) return false;
  }
  return are_apart(job.offsets, floats_of_offsets, job.velocities, floats_of_offsets);
}

bool is_valid(const OffsetApplyJob& job) {
  return is_aligned(job.target) && is_aligned(job.offsets) && is_aligned(job.velocities) && is_aligned(job.out) &&
         is_share(job.decay.offset) && is_not_negative(job.decay.velocity) && is_component_count(job.components) &&
         are_apart(job.offsets, floats_of_offsets, job.out, captured_floats) &&
         are_apart(job.velocities, floats_of_offsets, job.out, captured_floats);
}

bool is_valid(const NoiseJob& job) {
  const auto is_shaken = [](const ShakenBones& bones) {
    return is_aligned(bones.from) && is_aligned(bones.out) && is_moment(bones.moment) &&
           are_bone_weights(bones.bone_weights);
  };
  return job.packet >= 0 && job.bone_count >= 0 && is_component_count(job.components) &&
         std::ranges::all_of(job.characters, is_shaken);
}

bool is_valid(const PoseView& pose) {
  return is_aligned(pose.first, quad_alignment) && is_component_count(pose.components) && pose.bone_count >= 0 &&
         pose.packet_stride >= static_cast<std::size_t>(pose.components) * packet_bones;
}

}  // namespace throng::anim
