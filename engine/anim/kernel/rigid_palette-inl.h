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

/// A bone turned by `rotation` and moved by `displacement` about its pivot, under its parent's motion (ReferenceFrame):
///     R = R_parent * R',   t = t_parent + R_parent * (pivot + displacement) - R * pivot
template <class D, class V>
HWY_INLINE RigidMotion<V> move_bone(D d, const RigidMotion<V>& parent, const Quaternions<V>& rotation,
                                    const Vectors<V>& displacement, const Vectors<V>& pivot) {
  RigidMotion<V> motion;
  motion.rotation = product(parent.rotation, rotation);
  motion.matrix = rotation_matrices(d, motion.rotation);
  motion.translation = transform_subtract(motion.matrix, pivot,
                                          transform_add(parent.matrix, sum(pivot, displacement), parent.translation));
  return motion;
}

/// The bones [begin, end) of one packet, for one vector of characters of a tile of `width`.
template <int width, class D>
HWY_INLINE void rigid_palette_lanes(D d, const ModelPaletteJob& job, int lane, int begin, int end) {
  constexpr int lanes = lane_count<D>;
  const HierarchyProgram& program = *job.hierarchy;
  const float* local = job.local + lane * rigid_components * packet_bones;
  const int characters = HWY_MIN(job.characters - lane, lanes);
  alignas(64) FloatArray<4 * rigid_components * lanes> inputs;
  PaletteStage<D> stage;
  auto motion = begin == 0 ? no_motion(d) : load_motion(d, job.carry + lane, width);
  for (int four = begin; four < end; four += 4) {
    gather_four_bones<rigid_components>(d, local + (four - begin), inputs);
    const int count = HWY_MIN(end - four, 4);
    for (int i = 0; i < count; ++i) {
      const HierarchyStep step = program.steps.data()[four + i];
      if (step.load >= 0) {
        motion = load_motion(d, job.branch_slots + step.load * branch_slot_floats * width + lane, width);
      } else if (step.load == HierarchyStep::from_root) {
        motion = no_motion(d);
      }
      stage.prefetch(job.palettes + lane, characters, four, i);
      const float* input = inputs + i * rigid_components * lanes;
      motion = move_bone(d, motion, load_quaternions(d, input, lanes), load_vectors(d, input + 4 * lanes, lanes),
                         broadcast_vector(d, program.pivots.data() + 3 * (four + i)));
      if (step.store >= 0) {
        store_motion(d, motion, job.branch_slots + step.store * branch_slot_floats * width + lane, width);
      }
      stage.put(d, i, motion.matrix, motion.translation);
    }
    stage.write(job.palettes + lane, characters, four, count);
    if (job.hashes != nullptr) {
      stage.add_hashes(program.skin_joint.data() + four, characters, count, job.hashes + lane);
    }
  }
  store_motion(d, motion, job.carry + lane, width);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
