#if defined(THRONG_KERNEL_MODEL_JOINTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MODEL_JOINTS_INL_H
#undef THRONG_KERNEL_MODEL_JOINTS_INL_H
#else
#define THRONG_KERNEL_MODEL_JOINTS_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/palette/joint_writer-inl.h"
#include "engine/anim/kernel/palette/model_joints.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

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
