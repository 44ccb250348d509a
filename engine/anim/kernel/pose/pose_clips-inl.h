#if defined(THRONG_KERNEL_POSE_CLIPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_POSE_CLIPS_INL_H
#undef THRONG_KERNEL_POSE_CLIPS_INL_H
#else
#define THRONG_KERNEL_POSE_CLIPS_INL_H
#endif

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "engine/anim/kernel/pose/blend-inl.h"
#include "engine/anim/kernel/pose/pose_clips.h"
#include "engine/anim/kernel/pose/sample-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Blends that are made side by side, step by step, so that none waits for its own sums: the window of some processors
/// holds hardly more than one blend. With 16 registers some values are spilled, and it is faster nevertheless. Three or
/// four at once are no faster.
inline constexpr std::size_t blended_together = 2;

HWY_INLINE float* local_of(const PoseClipsJob& job, std::size_t character) {
  return job.local + character * static_cast<std::size_t>(job.components) * packet_bones;
}

HWY_INLINE const SampledPacket& packet_of(const PoseClipsJob& job, const ClipMoment& moment) {
  return moment.stream->packets()[job.packet];
}

HWY_INLINE void sample_moment(const PoseClipsJob& job, const ClipMoment& moment, float* local) {
  const Wanted wanted{.positions = job.displaced, .scales = scaled_quads(job.components)};
  sample_packet(moment.point, packet_of(job, moment), wanted, local);
}

/// Blends of two clips, of `count` characters.
template <std::size_t count>
struct Blends {
  const ShownClips* shown[count];
  float* local[count];

  Blends(const PoseClipsJob& job, const std::uint8_t* characters) {
    for (std::size_t k = 0; k < count; ++k) {
      shown[k] = &job.characters[characters[k]];
      local[k] = local_of(job, characters[k]);
    }
  }
};

/// Returns whether all rotations move in all clips, which is the usual case.
template <std::size_t count>
HWY_INLINE bool all_move(const PoseClipsJob& job, const Blends<count>& blends) {
  std::int32_t offsets = 0;
  for (std::size_t k = 0; k < count; ++k) {
    offsets |= packet_of(job, *blends.shown[k]->clip).rotation_offset;
    offsets |= packet_of(job, *blends.shown[k]->blended).rotation_offset;
  }
  return offsets >= 0;
}

/// `moving` is all_move: then there is no branch between the sums.
template <bool moving, std::size_t count>
HWY_INLINE void blend_sampled_rotations(const PoseClipsJob& job, const Blends<count>& blends, int bone) {
  const BoneLanes d;
  constexpr std::size_t both = 2 * count;
  const ClipMoment* moments[both];
  Quaternions<Floats> q[both];
  for (std::size_t k = 0; k < count; ++k) moments[k] = blends.shown[k]->clip;
  for (std::size_t k = 0; k < count; ++k) moments[count + k] = blends.shown[k]->blended;
  for (std::size_t k = 0; k < both; ++k) {
    const SampledPacket& packet = packet_of(job, *moments[k]);
    q[k] =
        moving ? moving_rotations(moments[k]->point, packet, bone) : weighed_rotations(moments[k]->point, packet, bone);
  }
  Floats factors[both];
  if constexpr (moving) {
    Floats squared_lengths[both];
    dots<both>(q, q, squared_lengths);
    sampled_to_unit<both>(d, squared_lengths, factors);
  } else {
    for (std::size_t k = 0; k < both; ++k) factors[k] = factor_to_unit(packet_of(job, *moments[k]), q[k]);
  }
  for (std::size_t k = 0; k < both; ++k) {
    q[k] = with_identity_behind(packet_of(job, *moments[k]), bone, scaled(q[k], factors[k]));
  }
  Floats weights[count];
  for (std::size_t k = 0; k < count; ++k) weights[k] = hn::Set(d, blends.shown[k]->fraction);
  blend_rotations<count>(d, q, q + count, weights, q);
  for (std::size_t k = 0; k < count; ++k) store(d, q[k], blends.local[k] + bone, packet_bones);
}

/// Writes positions or scales, which `range_of` selects, to planes that begin `first` floats behind each local pose.
template <std::size_t count, class RangeOf>
HWY_INLINE void blend_sampled_quads(const PoseClipsJob& job, const Blends<count>& blends, QuadMask quads, int first,
                                    RangeOf&& range_of) {
  const BoneLanes d;
  for_each_quad(quads, [&](int quad, int lane) {
    const auto sampled = [&](const ClipMoment& moment) {
      return sampled_quad(moment.point, range_of(packet_of(job, moment)), quad, lane);
    };
    Floats from[count], to[count];
    for (std::size_t k = 0; k < count; ++k) from[k] = sampled(*blends.shown[k]->clip);
    for (std::size_t k = 0; k < count; ++k) to[k] = sampled(*blends.shown[k]->blended);
    for (std::size_t k = 0; k < count; ++k) {
      const Floats between = hn::MulAdd(hn::Sub(to[k], from[k]), hn::Set(d, blends.shown[k]->fraction), from[k]);
      store_quad(d, between, lane, blends.local[k] + first + quad * quad_bones);
    }
  });
}

template <std::size_t count>
HWY_INLINE void pose_blends(const PoseClipsJob& job, const Blends<count>& blends) {
  blend_sampled_quads(job, blends, job.displaced, 4 * packet_bones, positions_of);
  blend_sampled_quads(job, blends, scaled_quads(job.components), 7 * packet_bones, scales_of);
  const bool moving = all_move(job, blends);
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    if (moving) {
      blend_sampled_rotations<true>(job, blends, bone);
    } else {
      blend_sampled_rotations<false>(job, blends, bone);
    }
  }
}

inline void pose_clips(const PoseClipsJob& shared) {
  assert(is_valid(shared));
  const PoseClipsJob job = shared;  // a copy, since the compiler would read the job again after each store
  std::uint8_t blended[widest_strip];
  std::size_t blends = 0;
  for (std::size_t character = 0; character < job.characters.size(); ++character) {
    const ShownClips& shown = job.characters[character];
    if (shown.blended != nullptr) {
      blended[blends++] = static_cast<std::uint8_t>(character);
    } else if (shown.clip != nullptr) {
      sample_moment(job, *shown.clip, local_of(job, character));
    }
  }
  std::size_t done = 0;
  for (; done + blended_together <= blends; done += blended_together) {
    pose_blends(job, Blends<blended_together>(job, blended + done));
  }
  for (; done < blends; ++done) pose_blends(job, Blends<1>(job, blended + done));
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
