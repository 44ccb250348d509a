#if defined(THRONG_KERNEL_RIGID_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_RIGID_PALETTE_INL_H
#undef THRONG_KERNEL_RIGID_PALETTE_INL_H
#else
#define THRONG_KERNEL_RIGID_PALETTE_INL_H
#endif

#include "engine/anim/kernel/palette_stage-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// How a bone has moved from its bind pose, in model space: point -> matrix * point + translation.
template <class V>
struct RigidMotion {
  Quaternions<V> rotation;
  Matrices<V> matrix;
  Vectors<V> translation;
};
static_assert(branch_slot_floats == 4 + 9 + 3);

template <class D, class V = hn::Vec<D>>
HWY_INLINE RigidMotion<V> no_motion(D d) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0F);
  return {{zero, zero, zero, one}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}, {zero, zero, zero}};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE RigidMotion<V> load_motion(D d, const float* slot, int stride) {
  return {load_quaternions(d, slot, stride), load_matrices(d, slot + 4 * stride, stride),
          load_vectors(d, slot + 13 * stride, stride)};
}

template <class D, class V>
HWY_INLINE void store_motion(D d, const RigidMotion<V>& motion, float* slot, int stride) {
  store(d, motion.rotation, slot, stride);
  store(d, motion.matrix, slot + 4 * stride, stride);
  store(d, motion.translation, slot + 13 * stride, stride);
}

/// A bone turned by `rotation` about its pivot, which was moved to `displaced`, under its parent's motion
/// (ReferenceFrame):
///     R = R_parent * R',   t = t_parent + R_parent * (pivot + displacement) - R * pivot
template <class D, class V>
HWY_INLINE RigidMotion<V> move_bone(D d, const RigidMotion<V>& parent, const Quaternions<V>& rotation,
                                    const Vectors<V>& pivot, const Vectors<V>& displaced) {
  RigidMotion<V> motion;
  motion.rotation = product(parent.rotation, rotation);
  motion.matrix = rotation_matrices(d, motion.rotation);
  motion.translation =
      transform_subtract(motion.matrix, pivot, transform_add(parent.matrix, displaced, parent.translation));
  return motion;
}

/// A bone's displaced pivot.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> displaced_pivot(D d, const Vectors<V>& pivot, const float* displacement, int stride) {
  return displacement == nullptr ? pivot : sum(pivot, load_vectors(d, displacement, stride));
}

/// The bones [begin, end) of one packet, for one vector of characters of a tile of `width`.
template <int width, class D>
HWY_INLINE void rigid_palette_lanes(D d, const ModelPaletteJob& job, int lane, int begin, int end) {
  constexpr int lanes = lane_count<D>;
  const HierarchyProgram& program = *job.hierarchy;
  const float* local = job.local + lane * rigid_components * packet_bones;
  const PaletteLines out = palette_lines(job, lane, lanes);
  const int wanted = job.displaced ? rigid_components : 4;
  alignas(64) FloatArray<4 * rigid_components * lanes> inputs;
  PaletteStage<D> stage;
  auto motion = begin == 0 ? no_motion(d) : load_motion(d, job.carry + lane, width);
  constexpr int group = PaletteStage<D>::entries;
  for (int first = begin; first < end; first += group) {
    const int count = HWY_MIN(end - first, group);
    const int before = first - group;
    for (int i = 0; i < count; ++i) {
      const int bone = first + i;
      if (i % 4 == 0) gather_four_bones<rigid_components>(d, local + (bone - begin), wanted, inputs);
      const HierarchyStep& step = program.steps.data()[bone];
      if (step.load >= 0) {
        motion = load_motion(d, job.branch_slots + step.load * branch_slot_floats * width + lane, width);
      } else if (step.load == HierarchyStep::from_root) {
        motion = no_motion(d);
      }
      if (out.stores == StorePolicy::prefetched) stage.prefetch(out, first, i);
      const float* input = inputs + i % 4 * rigid_components * lanes;
      const auto pivot = broadcast_vector(d, program.pivots.data() + 3 * bone);
      motion = move_bone(d, motion, load_quaternions(d, input, lanes), pivot,
                         displaced_pivot(d, pivot, job.displaced ? input + 4 * lanes : nullptr, lanes));
      if (step.store >= 0) {
        store_motion(d, motion, job.branch_slots + step.store * branch_slot_floats * width + lane, width);
      }
      stage.put(d, i, motion.matrix, motion.translation);
      if (before >= begin) stage.write_part(out, before, i);
    }
    for (int part = count; part < group && before >= begin; ++part) stage.write_part(out, before, part);
    stage.turn();
    if (job.hashes != nullptr) {
      stage.add_hashes(program.skin_joint.data() + first, out.characters, count, job.hashes + lane);
    }
  }
  const int last = begin + (end - begin - 1) / group * group;
  stage.write(out, last, end - last);
  store_motion(d, motion, job.carry + lane, width);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
