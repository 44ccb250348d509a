#if defined(THRONG_KERNEL_MODEL_JOINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MODEL_JOINTS_INL_H
#undef THRONG_KERNEL_MODEL_JOINTS_INL_H
#else
#define THRONG_KERNEL_MODEL_JOINTS_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/palette/general_palette-inl.h"
#include "engine/anim/kernel/palette/model_joints.h"
#include "engine/anim/kernel/palette/rigid_palette-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Writes joints of one vector of characters in one format.
template <JointFormat format, class D>
class JointWriter {
  using V = hn::Vec<D>;

 public:
  explicit JointWriter(float* const* to) : to_(to) {}

  /// Writes all joints that the bone of a step carries.
  template <class Carrier>
  HWY_INLINE void write_all(D d, const JointProgram& program, int step, const Carrier& carrier) const {
    const int last = program.first_joint[static_cast<std::size_t>(step) + 1];
    for (int joint = program.first_joint[static_cast<std::size_t>(step)]; joint < last; ++joint) {
      write(d, carrier, program.joints[static_cast<std::size_t>(joint)]);
    }
  }

 private:
  HWY_INLINE void write(D d, const RigidMotion<V>& motion, const PlacedJoint& joint) const {
    if constexpr (format == JointFormat::transforms) {
      const Quaternions<V> turn{hn::Set(d, joint.rotation[0]), hn::Set(d, joint.rotation[1]),
                                hn::Set(d, joint.rotation[2]), hn::Set(d, joint.rotation[3])};
      const Quaternions<V> q = product(motion.rotation, turn);
      const Vectors<V> p = position(d, motion, joint);
      const FourVectors<V> rows[2] = {{{q.x, q.y, q.z, q.w}}, {{p.x, p.y, p.z, hn::Set(d, joint.scale)}}};
      store_rows_of_four<2>(d, rows, to_, 4, joint.at);
    } else if (joint.turns) {
      const Affine<V> post = broadcast_affine(d, joint.rows[0]);
      write(d,
            {{row_times_matrix(motion.matrix.x, post.matrix), row_times_matrix(motion.matrix.y, post.matrix),
              row_times_matrix(motion.matrix.z, post.matrix)},
             position(d, motion, joint)},
            joint.at);
    } else {
      write(d, {motion.matrix, position(d, motion, joint)}, joint.at);
    }
  }

  HWY_INLINE void write(D d, const Affine<V>& global, const PlacedJoint& joint) const {
    if (!joint.turns && !joint.moves) return write(d, global, joint.at);
    write(d, product(global, broadcast_affine(d, joint.rows[0])), joint.at);
  }

  static HWY_INLINE Vectors<V> position(D d, const RigidMotion<V>& motion, const PlacedJoint& joint) {
    if (!joint.moves) return motion.joint;
    const Vectors<V> from_origin{hn::Set(d, joint.rows[0][3]), hn::Set(d, joint.rows[1][3]),
                                 hn::Set(d, joint.rows[2][3])};
    return transform_add(motion.matrix, from_origin, motion.joint);
  }

  HWY_INLINE void write(D d, const Affine<V>& joint, int at) const {
    const auto& [x, y, z] = joint.matrix;
    const Vectors<V>& move = joint.translation;
    if constexpr (format == JointFormat::matrices_4x4) {
      const V zero = hn::Zero(d);
      const FourVectors<V> columns[4] = {{{x.x, y.x, z.x, zero}},
                                         {{x.y, y.y, z.y, zero}},
                                         {{x.z, y.z, z.z, zero}},
                                         {{move.x, move.y, move.z, hn::Set(d, 1.0F)}}};
      store_rows_of_four<4>(d, columns, to_, 4, at);
    } else {
      const FourVectors<V> rows[3] = {{{x.x, x.y, x.z, move.x}}, {{y.x, y.y, y.z, move.y}}, {{z.x, z.y, z.z, move.z}}};
      store_rows_of_four<3>(d, rows, to_, 4, at);
    }
  }

  float* const* to_;
};

/// Gathers quads of bones of one vector of characters when the first bone of a quad is asked for.
template <int components, class D>
class BoneInputs {
  static constexpr int lanes = lane_count<D>;

 public:
  BoneInputs(const ModelJointsJob& job, int lane) : local_(job.local + lane * components * packet_bones) {}

  HWY_INLINE const float* of(D d, int in_packet, int wanted) {
    const int quad = in_packet / quad_bones;
    if (quad != quad_) gather_four_bones<components>(d, local_ + quad * quad_bones, wanted, inputs_);
    quad_ = quad;
    return inputs_ + in_packet % quad_bones * components * lanes;
  }

 private:
  const float* local_;
  int quad_ = -1;
  alignas(64) FloatArray<quad_bones * components * lanes> inputs_;
};

template <JointFormat format, int width, class D>
HWY_INLINE void rigid_joints(D d, const ModelJointsJob& job, int lane, int begin, int end) {
  constexpr int lanes = lane_count<D>;
  const JointProgram& program = *job.program;
  const HierarchyProgram& hierarchy = program.hierarchy;
  const JointWriter<format, D> writer(job.to + lane);
  BoneInputs<rigid_components, D> inputs(job, lane);
  RigidMotion<hn::Vec<D>> motion;
  reset(d, motion);
  if (begin > 0) load(d, job.carry + lane, width, motion);
  float* const slots = job.branch_slots + lane;
  for (int i = begin; i < end; ++i) {
    const HierarchyStep& step = hierarchy.steps[static_cast<std::size_t>(i)];
    if (step.load >= 0) {
      load(d, slots + step.load * branch_slot_floats * width, width, motion);
    } else if (step.load == HierarchyStep::from_root) {
      reset(d, motion);
    }
    const int in_packet = program.bones[static_cast<std::size_t>(i)] % packet_bones;
    const bool displaced = is_in(job.displaced, in_packet / quad_bones);
    const float* const input = inputs.of(d, in_packet, displaced ? rigid_components : 4);
    move_on(d, hierarchy, i, load_quaternions(d, input, lanes), displaced ? input + 4 * lanes : nullptr, lanes, motion);
    if (step.store >= 0) store(d, motion, slots + step.store * branch_slot_floats * width, width);
    writer.write_all(d, program, i, motion);
  }
  store(d, motion, job.carry + lane, width);
}

template <JointFormat format, int width, class D>
HWY_INLINE void general_joints(D d, const ModelJointsJob& job, int lane, int begin, int end) {
  constexpr int lanes = lane_count<D>;
  const JointProgram& program = *job.program;
  const HierarchyProgram& hierarchy = program.hierarchy;
  const JointWriter<format, D> writer(job.to + lane);
  BoneInputs<general_components, D> inputs(job, lane);
  auto global = begin == 0 ? identity(d) : load_affine(d, job.carry + lane, width);
  float* const slots = job.branch_slots + lane;
  for (int i = begin; i < end; ++i) {
    const HierarchyStep& step = hierarchy.steps[static_cast<std::size_t>(i)];
    if (step.load >= 0) {
      global = load_affine(d, slots + step.load * branch_slot_floats * width, width);
    } else if (step.load == HierarchyStep::from_root) {
      global = identity(d);
    }
    if (hierarchy.has_prefix[static_cast<std::size_t>(i)] != 0) {
      global = product(global, broadcast_affine(d, hierarchy.prefixes.data() + i * matrix_floats));
    }
    const int in_packet = program.bones[static_cast<std::size_t>(i)] % packet_bones;
    global = product(global, load_local(d, inputs.of(d, in_packet, general_components), lanes));
    if (step.store >= 0) store_affine(d, global, slots + step.store * branch_slot_floats * width, width);
    writer.write_all(d, program, i, global);
  }
  store_affine(d, global, job.carry + lane, width);
}

template <JointFormat format, int width>
void model_joints_as(const ModelJointsJob& job) {
  using D = LanesUpTo<width>;
  const auto packet = static_cast<std::size_t>(job.packet);
  const int begin = job.program->first_step[packet], end = job.program->first_step[packet + 1];
  if (begin == end) return;
  for (int lane = 0; lane < width; lane += lane_count<D>) {
    if constexpr (format == JointFormat::transforms) {
      rigid_joints<format, width>(D(), job, lane, begin, end);
    } else if (job.program->hierarchy.rigid) {
      rigid_joints<format, width>(D(), job, lane, begin, end);
    } else {
      general_joints<format, width>(D(), job, lane, begin, end);
    }
  }
}

template <int width>
void model_joints_strip(const ModelJointsJob& job) {
  switch (job.program->format) {
    case JointFormat::transforms:
      return model_joints_as<JointFormat::transforms, width>(job);
    case JointFormat::matrices:
      return model_joints_as<JointFormat::matrices, width>(job);
    default:
      return model_joints_as<JointFormat::matrices_4x4, width>(job);
  }
}

void model_joints(const ModelJointsJob& job) {
  assert(is_valid(job));
  switch (job.width) {
    case 1:
      return model_joints_strip<1>(job);
    case 2:
      return model_joints_strip<2>(job);
    case 4:
      return model_joints_strip<4>(job);
    case 8:
      return model_joints_strip<8>(job);
    default:
      return model_joints_strip<widest_strip>(job);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // THRONG_KERNEL_MODEL_JOINTS_INL_H
