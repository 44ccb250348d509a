#if defined(THRONG_KERNEL_POSE_CLIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_POSE_CLIPS_INL_H
#undef THRONG_KERNEL_POSE_CLIPS_INL_H
#else
#define THRONG_KERNEL_POSE_CLIPS_INL_H
#endif

#include <cassert>
#include <cstddef>

#include "engine/anim/kernel/blend-inl.h"
#include "engine/anim/kernel/sample-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Blends that are made side by side, step by step, so that none waits for its own sums where a processor looks no
/// further ahead than one of them is long. With 16 registers some are spilled, and it is faster all the same.
inline constexpr std::size_t blended_together = 2;

HWY_INLINE float* local_of(const PoseClipsJob& job, const ClipMoment& moment) {
  return job.local + moment.character * job.components * packet_bones;
}

HWY_INLINE const SampledPacket& packet_of(const PoseClipsJob& job, const ClipMoment& moment) {
  return moment.stream->packets()[job.packet];
}

HWY_INLINE void sample_moment(const PoseClipsJob& job, const ClipMoment& moment) {
  const Wanted wanted{.positions = job.displaced, .scales = job.components == general_components};
  sample_packet(moment.point, packet_of(job, moment), wanted, local_of(job, moment));
}

template <std::size_t count>
HWY_INLINE void blend_sampled_rotations(const PoseClipsJob& job, const ClipMoment* const* from, const ClipMoment* to,
                                        int bone) {
  const BoneLanes d;
  constexpr std::size_t both = 2 * count;
  const ClipMoment* moments[both];
  Quaternions<Floats> q[both];
  Floats factors[both];
  for (std::size_t k = 0; k < both; ++k) moments[k] = k < count ? from[k] : to + (k - count);
  for (std::size_t k = 0; k < both; ++k) q[k] = weighed_rotations(moments[k]->point, packet_of(job, *moments[k]), bone);
  for (std::size_t k = 0; k < both; ++k) factors[k] = factor_to_unit(packet_of(job, *moments[k]), q[k]);
  for (std::size_t k = 0; k < both; ++k) q[k] = scaled(q[k], factors[k]);
  for (std::size_t k = 0; k < count; ++k) {
    q[k] = blend_rotations(d, q[k], q[count + k], hn::Set(d, to[k].fraction));
    store(d, q[k], local_of(job, to[k]) + bone, packet_bones);
  }
}

HWY_INLINE void blend_sampled_vectors(const ClipMoment& from, const ClipMoment& to, const SampledRange& from_range,
                                      const SampledRange& to_range, int bone, float* out) {
  const BoneLanes d;
  const Vectors<Floats> start = sampled_vectors(from.point, from_range, bone);
  const Vectors<Floats> way = difference(sampled_vectors(to.point, to_range, bone), start);
  const Floats fraction = hn::Set(d, to.fraction);
  const Vectors<Floats> between{hn::MulAdd(way.x, fraction, start.x), hn::MulAdd(way.y, fraction, start.y),
                                hn::MulAdd(way.z, fraction, start.z)};
  store(d, between, out, packet_bones);
}

/// The packet of each of `count` characters: a blend of `from` and `to`.
template <std::size_t count>
HWY_INLINE void pose_blends(const PoseClipsJob& job, const ClipMoment* const* from, const ClipMoment* to) {
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    blend_sampled_rotations<count>(job, from, to, bone);
    if (!job.displaced) continue;
    for (std::size_t k = 0; k < count; ++k) {
      const SampledPacket& start = packet_of(job, *from[k]);
      const SampledPacket& end = packet_of(job, to[k]);
      float* const out = local_of(job, to[k]) + bone;
      blend_sampled_vectors(*from[k], to[k], positions_of(start), positions_of(end), bone, out + 4 * packet_bones);
      if (job.components != general_components) continue;
      blend_sampled_vectors(*from[k], to[k], scales_of(start), scales_of(end), bone, out + 7 * packet_bones);
    }
  }
}

inline void pose_clips(const PoseClipsJob& shared) {
  const PoseClipsJob job = shared;  // or it would be read again after every store
  const ClipMoment* from[widest_tile];
  std::size_t blends = 0;
  for (const ClipMoment& clip : job.clips) {
    if (blends < job.blended.size() && job.blended[blends].character == clip.character) {
      from[blends++] = &clip;
    } else {
      sample_moment(job, clip);
    }
  }
  assert(blends == job.blended.size() && "not in the order of the clips that they are blended onto");
  std::size_t done = 0;
  for (; done + blended_together <= blends; done += blended_together) {
    pose_blends<blended_together>(job, from + done, &job.blended[done]);
  }
  for (; done < blends; ++done) pose_blends<1>(job, from + done, &job.blended[done]);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
