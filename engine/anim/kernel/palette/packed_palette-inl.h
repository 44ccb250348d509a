#if defined(THRONG_KERNEL_PACKED_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_PACKED_PALETTE_INL_H
#undef THRONG_KERNEL_PACKED_PALETTE_INL_H
#else
#define THRONG_KERNEL_PACKED_PALETTE_INL_H
#endif

#include "engine/anim/kernel/palette/packed_palette.h"
#include "engine/anim/kernel/palette/rigid_palette-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The motion of a joint, for packed palettes.
template <class V>
struct PackedMotion : JointMotion<V> {
  static constexpr int palette_rows = packed_rows;
};

template <class D, class V>
HWY_INLINE void reset(D d, PackedMotion<V>& motion) {
  const V zero = hn::Zero(d);
  motion = {{{zero, zero, zero, hn::Set(d, 1.0F)}, {zero, zero, zero}}};
}

/// a.y * b.z - a.z * b.y and so on, added to `start`.
template <class V>
HWY_INLINE Vectors<V> cross_add(const Quaternions<V>& a, const Vectors<V>& b, const Vectors<V>& start) {
  return {hn::NegMulAdd(a.z, b.y, hn::MulAdd(a.y, b.z, start.x)),
          hn::NegMulAdd(a.x, b.z, hn::MulAdd(a.z, b.x, start.y)),
          hn::NegMulAdd(a.y, b.x, hn::MulAdd(a.x, b.y, start.z))};
}

/// start + q v q^-1, of a unit q: v + 2 u x (u x v + w v), u the vector part.
template <class V>
HWY_INLINE Vectors<V> rotate_add(const Quaternions<V>& q, const Vectors<V>& v, const Vectors<V>& start) {
  const Vectors<V> turned = cross_add(q, v, {hn::Mul(q.w, v.x), hn::Mul(q.w, v.y), hn::Mul(q.w, v.z)});
  const Vectors<V> twice = sum(turned, turned);
  return cross_add(q, twice, sum(start, v));
}

/// The same as for a RigidMotion, by the rotation instead of its matrix.
template <class D, class V>
HWY_INLINE void move_on(D d, const HierarchyProgram& program, int bone, const Quaternions<V>& rotation,
                        const float* displacement, int stride, PackedMotion<V>& motion) {
  const auto offset = broadcast_vector(d, program.offsets.data() + 3 * bone);
  motion.joint = rotate_add(motion.rotation, displaced(d, offset, displacement, stride), motion.joint);
  motion.rotation = product(motion.rotation, rotation);
}

/// Round(x * scale) in the low 22 bits of each lane, two's complement: the mantissa of a sum with 1.5 * 2^23.
template <class D, class V = hn::Vec<D>, class Words = hn::Vec<hn::RebindToUnsigned<D>>>
HWY_INLINE Words rounded_bits(D d, V x, V scale) {
  return hn::BitCast(hn::RebindToUnsigned<D>(), hn::MulAdd(x, scale, hn::Set(d, 12582912.0F)));
}

/// `low` below bit `bits`, `high` from there on.
template <int bits, class U, class Words = hn::Vec<U>>
HWY_INLINE Words join_bits(U u, Words low, Words high) {
  return hn::OrAnd(hn::ShiftLeft<bits>(high), low, hn::Set(u, (1U << bits) - 1U));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V within(D d, V x, float limit) {
  return hn::Min(hn::Max(x, hn::Set(d, -limit)), hn::Set(d, limit));
}

template <class D, class V, class Packet>
HWY_INLINE void put(D d, const HierarchyProgram& program, int bone, const PackedMotion<V>& motion,
                    PaletteStage<D, packed_rows, Packet>& stage) {
  const hn::RebindToUnsigned<D> u;
  const V one = hn::Set(d, packed_rotation_one);
  const Quaternions<V>& q = motion.rotation;
  const auto xy = join_bits<16>(u, rounded_bits(d, q.x, one), rounded_bits(d, q.y, one));
  const auto zw = join_bits<16>(u, rounded_bits(d, q.z, one), rounded_bits(d, q.w, one));
  const float limit = packed_joint_limit * program.joint_step;
  const V steps = hn::Set(d, 1.0F / program.joint_step);
  const auto x = rounded_bits(d, within(d, motion.joint.x, limit), steps);
  const auto y = rounded_bits(d, within(d, motion.joint.y, limit), steps);
  const auto z = rounded_bits(d, within(d, motion.joint.z, limit), steps);
  const auto joint_low = join_bits<packed_joint_bits>(u, x, y);
  const auto joint_high = join_bits<10>(u, hn::ShiftRight<11>(y), z);
  stage.put_row(d, bone % stage.entries, 0,
                Vectors<V>{hn::BitCast(d, xy), hn::BitCast(d, zw), hn::BitCast(d, joint_low)},
                hn::BitCast(d, joint_high));
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
