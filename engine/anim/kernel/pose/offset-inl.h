#if defined(THRONG_KERNEL_OFFSET_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_OFFSET_INL_H
#undef THRONG_KERNEL_OFFSET_INL_H
#else
#define THRONG_KERNEL_OFFSET_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/rotation_vector-inl.h"
#include "engine/anim/kernel/pose/offset.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class V>
struct Offsets {
  Quaternions<V> rotation;
  Vectors<V> position;
};

/// `shown` against `target`, rotations on the hemisphere of `near`.
template <class D, class V>
HWY_INLINE Offsets<V> offsets_between(D d, const float* shown, const float* target, const Quaternions<V>& near) {
  constexpr int positions = 4 * packet_bones;
  const auto turn = renormalised(
      d, product(load_quaternions(d, shown, packet_bones), conjugate(load_quaternions(d, target, packet_bones))));
  const V side = hn::CopySign(hn::Set(d, 1.0F), dot(turn, near));
  return {scaled(turn, side), difference(load_vectors(d, shown + positions, packet_bones),
                                         load_vectors(d, target + positions, packet_bones))};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void capture_lanes(D d, const OffsetCaptureJob& job, float per_second, int bone) {
  const V zero = hn::Zero(d);
  const auto now =
      offsets_between(d, job.shown + bone, job.target + bone, Quaternions<V>{zero, zero, zero, hn::Set(d, 1.0F)});
  const auto turn = rotation_vectors(d, now.rotation);
  store(d, turn, job.offsets + bone, packet_bones);
  store(d, now.position, job.offsets + 3 * packet_bones + bone, packet_bones);
  Vectors<V> turning{zero, zero, zero};
  Vectors<V> moving = turning;
  if (per_second > 0.0F) {
    const float* target_before = job.target_before != nullptr ? job.target_before : job.target;
    const auto before = offsets_between(d, job.shown_before + bone, target_before + bone, now.rotation);
    const V rate = hn::Set(d, per_second);
    turning = scaled(difference(turn, rotation_vectors(d, before.rotation)), rate);
    moving = scaled(difference(now.position, before.position), rate);
  }
  store(d, no_longer_than(d, turning, fastest_offset_turn), job.velocities + bone, packet_bones);
  store(d, no_longer_than(d, moving, fastest_offset_move), job.velocities + 3 * packet_bones + bone, packet_bones);
}

inline void capture_offset(const OffsetCaptureJob& job) {
  assert(is_valid(job));
  const bool moves = job.shown_before != nullptr && job.seconds_between > 0.0F;
  const float per_second = moves ? 1.0F / job.seconds_between : 0.0F;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    capture_lanes(BoneLanes(), job, per_second, bone);
  }
}

/// offset * decay.offset + velocity * decay.velocity
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> decayed_offsets(D d, const OffsetApplyJob& job, int at) {
  const auto offset = load_vectors(d, job.offsets + at, packet_bones);
  const auto velocity = load_vectors(d, job.velocities + at, packet_bones);
  const V left = hn::Set(d, job.decay.offset);
  const V seconds = hn::Set(d, job.decay.velocity);
  return {hn::MulAdd(velocity.x, seconds, hn::Mul(offset.x, left)),
          hn::MulAdd(velocity.y, seconds, hn::Mul(offset.y, left)),
          hn::MulAdd(velocity.z, seconds, hn::Mul(offset.z, left))};
}

/// An offset of 0 keeps the bits, also of -0.
template <class D, class V>
HWY_INLINE V moved(D d, V from, V by) {
  return hn::IfThenElse(hn::Eq(by, hn::Zero(d)), from, hn::Add(from, by));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void apply_lanes(D d, const OffsetApplyJob& job, int bone) {
  constexpr int positions = 4 * packet_bones;
  const auto turn = decayed_offsets(d, job, bone);
  const auto move = decayed_offsets(d, job, 3 * packet_bones + bone);
  const auto rotation = load_quaternions(d, job.target + bone, packet_bones);
  const auto position = load_vectors(d, job.target + positions + bone, packet_bones);
  const auto turned = renormalised(d, product(rotations_by(d, turn), rotation));
  store(d, choose(hn::Eq(dot(turn, turn), hn::Zero(d)), rotation, turned), job.out + bone, packet_bones);
  store(d, Vectors<V>{moved(d, position.x, move.x), moved(d, position.y, move.y), moved(d, position.z, move.z)},
        job.out + positions + bone, packet_bones);
  copy_components(d, job.target + bone, job.out + bone, rigid_components, job.components);
}

inline void apply_offset(const OffsetApplyJob& job) {
  assert(is_valid(job));
  const BoneLanes d;
  const bool ended = job.decay.offset == 0.0F && job.decay.velocity == 0.0F;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    if (ended) {
      copy_components(d, job.target + bone, job.out + bone, 0, job.components);
    } else {
      apply_lanes(d, job, bone);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
