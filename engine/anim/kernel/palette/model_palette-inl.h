#if defined(THRONG_KERNEL_MODEL_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MODEL_PALETTE_INL_H
#undef THRONG_KERNEL_MODEL_PALETTE_INL_H
#else
#define THRONG_KERNEL_MODEL_PALETTE_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/palette/general_palette-inl.h"
#include "engine/anim/kernel/palette/joint_writer-inl.h"
#include "engine/anim/kernel/palette/packed_palette-inl.h"
#include "engine/anim/kernel/palette/rigid_palette-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// No joints are listed.
struct NothingBeside {
  template <class D, class Carrier>
  HWY_INLINE void write(D /*d*/, int /*bone*/, const Carrier& /*carrier*/) const {}
};

/// Writes the listed joints of a packet, bone after bone.
template <class D>
class JointsBeside {
 public:
  JointsBeside(const ModelPaletteJob& job, int lane) : program_(job.joints), to_(job.joints_to + lane) {
    const auto packet = static_cast<std::size_t>(job.packet);
    next_ = program_->carriers.data() + program_->first_carrier[packet];
    last_ = program_->carriers.data() + program_->first_carrier[packet + 1];
    find_bone();
  }

  template <class Carrier>
  HWY_INLINE void write(D d, int bone, const Carrier& carrier) {
    if (bone != bone_) return;
    const Carrier copied = carrier;  // the loop keeps its own in registers
    write_step(d, *program_, *next_++, copied, to_);
    find_bone();
  }

 private:
  void find_bone() { bone_ = next_ == last_ ? -1 : program_->bones[static_cast<std::size_t>(*next_)]; }

  template <class Carrier>
  static HWY_NOINLINE void write_step(D d, const JointProgram& program, int step, const Carrier& carrier,
                                      float* const* to) {
    if (program.format == JointFormat::matrices) {
      JointWriter<JointFormat::matrices, D>(to).write_all(d, program, step, carrier);
    } else if (program.format == JointFormat::matrices_4x4) {
      JointWriter<JointFormat::matrices_4x4, D>(to).write_all(d, program, step, carrier);
    } else if constexpr (Carrier::turns_as_quaternion) {
      JointWriter<JointFormat::transforms, D>(to).write_all(d, program, step, carrier);
    }
  }

  const JointProgram* program_;
  float* const* to_;
  const std::int16_t* next_;
  const std::int16_t* last_;
  int bone_ = -1;
};

template <int width, class D, class Beside>
HWY_INLINE void matrix_palette_lanes(D d, const ModelPaletteJob& job, int lane, int begin, int end, Beside beside) {
  if (job.hierarchy->rigid) {
    rigid_palette_lanes<RigidMotion, width>(d, job, lane, begin, end, beside);
  } else {
    general_palette_lanes<width>(d, job, lane, begin, end, beside);
  }
}

template <int width>
void model_palette_strip(const ModelPaletteJob& job) {
  using D = LanesUpTo<width>;
  const int begin = job.packet * packet_bones;
  const int end = HWY_MIN(begin + packet_bones, job.bone_count);
  if (begin >= end) return;
  const bool lists = job.joints != nullptr && job.joints->carries(job.packet);
  for (int lane = 0; lane < job.characters; lane += lane_count<D>) {
    if (job.format == PaletteFormat::packed) {
      rigid_palette_lanes<PackedMotion, width>(D(), job, lane, begin, end, NothingBeside());
    } else if (lists) {
      matrix_palette_lanes<width>(D(), job, lane, begin, end, JointsBeside<D>(job, lane));
    } else {
      matrix_palette_lanes<width>(D(), job, lane, begin, end, NothingBeside());
    }
  }
}

void model_palette(const ModelPaletteJob& job) {
  assert(is_valid(job));
  switch (job.width) {
    case 1:
      return model_palette_strip<1>(job);
    case 2:
      return model_palette_strip<2>(job);
    case 4:
      return model_palette_strip<4>(job);
    case 8:
      return model_palette_strip<8>(job);
    default:
      return model_palette_strip<widest_strip>(job);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // THRONG_KERNEL_MODEL_PALETTE_INL_H
