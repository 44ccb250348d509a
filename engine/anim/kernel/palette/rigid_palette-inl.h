#if defined(THRONG_KERNEL_RIGID_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_RIGID_PALETTE_INL_H
#undef THRONG_KERNEL_RIGID_PALETTE_INL_H
#else
#define THRONG_KERNEL_RIGID_PALETTE_INL_H
#endif

#include "engine/anim/kernel/palette/palette_stage-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The rotation of a bone from its bind pose and the position of its joint, model space.
template <class V>
struct JointMotion {
  Quaternions<V> rotation;
  Vectors<V> joint;
};
static_assert(branch_slot_floats >= 4 + 3);

template <class D, class V>
HWY_INLINE void load(D d, const float* slot, int stride, JointMotion<V>& motion) {
  motion = {load_quaternions(d, slot, stride), load_vectors(d, slot + 4 * stride, stride)};
}

template <class D, class V>
HWY_INLINE void store(D d, const JointMotion<V>& motion, float* slot, int stride) {
  store(d, motion.rotation, slot, stride);
  store(d, motion.joint, slot + 4 * stride, stride);
}

/// The motion of a joint with its matrix, for palettes of matrices. A branch slot holds no matrix: making it again
/// is cheaper than loading it.
template <class V>
struct RigidMotion : JointMotion<V> {  ///< rotations of length root_of_two
  static constexpr int palette_rows = matrix_rows;
  static constexpr bool turns_as_quaternion = true;  // has the parts of a JointTransform
  Matrices<V> matrix;
};

template <class D, class V>
HWY_INLINE void reset(D d, RigidMotion<V>& motion) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0F);
  motion = {{{zero, zero, zero, hn::Set(d, root_of_two)}, {zero, zero, zero}},
            {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
}

template <class D, class V>
HWY_INLINE void load(D d, const float* slot, int stride, RigidMotion<V>& motion) {
  load(d, slot, stride, static_cast<JointMotion<V>&>(motion));
  motion.matrix = rotation_matrices(d, motion.rotation);
}

/// Adds a displacement, if there is one, to a vector of the bind pose.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> displaced(D d, const Vectors<V>& at_rest, const float* displacement, int stride) {
  return displacement == nullptr ? at_rest : sum(at_rest, load_vectors(d, displacement, stride));
}

/// Turns the `motion` of the parent into a bone's. `rotation` is about its joint, which `displacement` moves if
/// it is not null:
///     R = R_parent * R',   joint = joint_parent + R_parent * (offset + displacement)
/// The parent's matrix is not used after that, because 16 registers do not hold two matrices.
template <class D, class V>
HWY_INLINE void move_on(D d, const HierarchyProgram& program, int bone, const Quaternions<V>& rotation,
                        const float* displacement, int stride, RigidMotion<V>& motion) {
  motion.rotation = product(motion.rotation, rotation);
  const auto offset = broadcast_vector(d, program.offsets.data() + 3 * bone);
  motion.joint = transform_add(motion.matrix, displaced(d, offset, displacement, stride), motion.joint);
  motion.matrix = rotation_matrices(d, motion.rotation);
}

/// point -> R * (point - joint in the bind pose) + joint
template <class D, class V, class Packet>
HWY_INLINE void put(D d, const HierarchyProgram& program, int bone, const RigidMotion<V>& motion,
                    PaletteStage<D, matrix_rows, Packet>& stage) {
  const auto back = broadcast_vector(d, program.to_model_origin.data() + 3 * bone);
  stage.put(d, bone % stage.entries, motion.matrix, transform_add(motion.matrix, back, motion.joint));
}

/// Does the work of rigid_palette_lanes; the compiler may know the members of `packet`.
template <template <class> class MotionOf, int width, class D, class Packet, class Beside>
HWY_INLINE void rigid_palette_packet(D d, const ModelPaletteJob& job, int lane, int begin, int end, Packet packet,
                                     Beside beside) {
  using Motion = MotionOf<hn::Vec<D>>;
  using Stage = PaletteStage<D, Motion::palette_rows, Packet>;
  constexpr int lanes = lane_count<D>;
  const HierarchyProgram& program = *job.hierarchy;
  const HierarchyStep* const steps = program.steps.data();
  const float* local = job.local + lane * rigid_components * packet_bones;
  float* const branch_slots = job.branch_slots + lane;
  alignas(64) FloatArray<4 * rigid_components * lanes> inputs;
  typename Stage::Memory staged;
  Stage stage(job.palettes + lane, packet, begin, staged);
  Motion motion;
  reset(d, motion);
  if (begin > 0) load(d, job.carry + lane, width, motion);
  constexpr int group = Stage::entries;
  static_assert(group == quad_bones);
  for (int first = begin; first < end; first += group) {
    const int count = HWY_MIN(end - first, group);
    const bool one_before = first > begin;
    const bool displaced = packet.displaced && is_in(job.displaced, (first - begin) / quad_bones);
    gather_four_bones<rigid_components>(d, local + (first - begin), displaced ? rigid_components : 4, inputs);
    for (int i = 0; i < count; ++i) {
      const int bone = first + i;
      const HierarchyStep& step = steps[bone];
      if (step.load >= 0) {
        load(d, branch_slots + step.load * branch_slot_floats * width, width, motion);
      } else if (step.load == HierarchyStep::from_root) {
        reset(d, motion);
      }
      if (packet.stores == StorePolicy::prefetched) stage.prefetch(i);
      const float* input = inputs + i * rigid_components * lanes;
      move_on(d, program, bone, load_quaternions(d, input, lanes), displaced ? input + 4 * lanes : nullptr, lanes,
              motion);
      if (step.store >= 0) store(d, motion, branch_slots + step.store * branch_slot_floats * width, width);
      put(d, program, bone, motion, stage);
      beside.write(d, bone, motion);
      if (one_before) stage.write_part(i);
    }
    for (int part = count; part < group && one_before; ++part) stage.write_part(part);
    stage.turn();
    if (packet.hashed) {
      stage.add_hashes(program.skin_joint.data() + first, count, job.hashes + lane);
    }
  }
  const int last = begin + (end - begin - 1) / group * group;
  stage.write(end - last);
  store(d, motion, job.carry + lane, width);
}

/// The bones [begin, end) of one packet, for one vector of characters of a strip of `width`. `beside` is called for
/// each bone.
template <template <class> class MotionOf, int width, class D, class Beside>
HWY_INLINE void rigid_palette_lanes(D d, const ModelPaletteJob& job, int lane, int begin, int end, Beside beside) {
  constexpr int lanes = lane_count<D>;
  const AnyPacket packet = any_packet(job, lane, lanes);
  const auto write = [&](auto known) {
    rigid_palette_packet<MotionOf, width>(d, job, lane, begin, end, known, beside);
  };
  if constexpr (width == widest_strip) {
    write_as_usual<lanes>(packet, write);
  } else {
    write(packet);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
