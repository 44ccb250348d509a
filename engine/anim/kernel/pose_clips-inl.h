#if defined(THRONG_KERNEL_POSE_CLIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_POSE_CLIPS_INL_H
#undef THRONG_KERNEL_POSE_CLIPS_INL_H
#else
#define THRONG_KERNEL_POSE_CLIPS_INL_H
#endif

#include <cstring>

#include "engine/anim/kernel/blend-inl.h"
#include "engine/anim/kernel/sample-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Clips that are sampled before any is blended: so many that none waits for its own sums, so few that they stay in
/// the nearest cache.
inline constexpr std::size_t sampled_together = 8;

HWY_INLINE float* local_of(const PoseClipsJob& job, const ClipMoment& moment) {
  return job.local + moment.character * job.components * packet_bones;
}

HWY_INLINE void sample_moment(const PoseClipsJob& job, const ClipMoment& moment, float* out) {
  const Wanted wanted{.positions = job.displaced, .scales = job.components == general_components};
  sample_packet(moment.point, moment.stream->packets()[job.packet], wanted, out);
}

/// The packet of a character becomes its blend with `to`.
HWY_INLINE void blend_onto(const PoseClipsJob& job, const ClipMoment& moment, const float* to) {
  float* from = local_of(job, moment);
  const BlendJob step{.from = from,
                      .to = to,
                      .fraction = moment.fraction,
                      .components = job.displaced ? job.components : 4,
                      .out = from};
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) blend_lanes(BoneLanes(), step, bone);
}

inline void pose_clips(const PoseClipsJob& shared) {
  const PoseClipsJob job = shared;  // or it would be read again after every store
  for (const ClipMoment& clip : job.clips) sample_moment(job, clip, local_of(job, clip));
  alignas(64) float to[sampled_together][general_components * packet_bones];
  for (std::size_t first = 0; first < job.blended.size(); first += sampled_together) {
    const auto blended = job.blended.subspan(first, HWY_MIN(sampled_together, job.blended.size() - first));
    for (std::size_t i = 0; i < blended.size(); ++i) sample_moment(job, blended[i], to[i]);
    for (std::size_t i = 0; i < blended.size(); ++i) blend_onto(job, blended[i], to[i]);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
