#if defined(THRONG_KERNEL_JOINT_WRITER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_JOINT_WRITER_INL_H
#undef THRONG_KERNEL_JOINT_WRITER_INL_H
#else
#define THRONG_KERNEL_JOINT_WRITER_INL_H
#endif

#include "engine/anim/kernel/palette/general_palette-inl.h"
#include "engine/anim/kernel/palette/joint_program.h"
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

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
