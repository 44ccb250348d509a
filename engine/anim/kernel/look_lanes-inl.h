// What gazes read and write of their characters, a character a lane.
#if defined(THRONG_KERNEL_LOOK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LOOK_LANES_INL_H
#undef THRONG_KERNEL_LOOK_LANES_INL_H
#else
#define THRONG_KERNEL_LOOK_LANES_INL_H
#endif

#include <span>

#include "engine/anim/kernel/angles-inl.h"
#include "engine/anim/kernel/look_at.h"
#include "engine/anim/kernel/transpose-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// One number of each character.
template <class D>
struct Lane {
  alignas(64) FloatArray<lane_count<D>> of;

  hn::Vec<D> load(D d) const { return hn::Load(d, of); }
  void store(D d, hn::Vec<D> value) { hn::Store(value, d, of); }
};

template <class V>
struct Gazes {
  V yaw, pitch;
};

/// DampedValue, smooth_damp.h.
template <class V>
struct DampedValues {
  V value, velocity;
};

/// Every lane holds a character: those beyond the last one repeat it.
template <class D>
struct LookLanes {
  using V = hn::Vec<D>;

  Lane<D> joints[JointChain::max_joints][rigid_components];
  Lane<D> target[3], weight, seconds, most_yaw, most_up, most_down, smooth_seconds, started;
  Lane<D> yaw, yaw_velocity, pitch, pitch_velocity, remaining;

  void load(const JointChain& chain, std::span<LookAtJob* const> jobs) {
    const LookAtJob* all[lane_count<D>];
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      all[lane] = jobs[HWY_MIN(static_cast<std::size_t>(lane), jobs.size() - 1)];
      load_gaze(*all[lane], lane);
    }
    load_poses(chain, all);
  }

  Quaternions<V> rotation(D d, int joint) const {
    const Lane<D>* parts = joints[joint];
    return {parts[0].load(d), parts[1].load(d), parts[2].load(d), parts[3].load(d)};
  }
  void set_rotation(D d, int joint, const Quaternions<V>& rotation) {
    Lane<D>* parts = joints[joint];
    parts[0].store(d, rotation.x);
    parts[1].store(d, rotation.y);
    parts[2].store(d, rotation.z);
    parts[3].store(d, rotation.w);
  }
  /// From the joint before, in its frame.
  Vectors<V> offset(D d, const JointChain& chain, int joint) const {
    const Vectors<V> bound = broadcast_vector(d, &chain.offsets.data()[joint].x);
    const Lane<D>* parts = joints[joint] + 4;
    return sum(bound, Vectors<V>{parts[0].load(d), parts[1].load(d), parts[2].load(d)});
  }

  void store(const LookAtRig& rig, std::span<LookAtJob* const> jobs) const {
    for (std::size_t lane = 0; lane < jobs.size(); ++lane) {
      LookAtJob& job = *jobs[lane];
      *job.state = {.yaw = {yaw.of[lane], yaw_velocity.of[lane]},
                    .pitch = {pitch.of[lane], pitch_velocity.of[lane]},
                    .started = true};
      job.remaining = remaining.of[lane];
    }
    for (int i = 0; i < rig.joint_count; ++i) store_rotation(rig.chain, rig.joints.data()[i], jobs);
  }

 private:
  static float* lane_of(const PoseView& pose, int bone) {
    const auto place = static_cast<unsigned>(bone);
    return pose.packet(static_cast<int>(place / packet_bones)) + place % packet_bones;
  }
  void store_rotation(const JointChain& chain, int joint, std::span<LookAtJob* const> jobs) const {
    const Lane<D>* const parts = joints[joint];
    const int bone = chain.bones.data()[joint];
    for (std::size_t lane = 0; lane < jobs.size(); ++lane) {
      float* const to = lane_of(jobs[lane]->pose, bone);
      for (int part = 0; part < 4; ++part) to[part * packet_bones] = parts[part].of[lane];
    }
  }
  /// Bones that lie side by side are read together, four of each character; positions of those that nobody displaces
  /// are not.
  void load_poses(const JointChain& chain, const LookAtJob* const* jobs) {
    const auto* bones = chain.bones.data();
    std::uint64_t displaced = 0;
    for (int lane = 0; lane < lane_count<D>; ++lane) displaced |= jobs[lane]->pose.displaced_quads;
    for (int first = 0, end = 0; first < chain.count; first = end) {
      const int quad = bones[first] / quad_bones;
      for (end = first + 1; end < chain.count && bones[end] / quad_bones == quad;) ++end;
      const float* from[lane_count<D>];
      for (int lane = 0; lane < lane_count<D>; ++lane) from[lane] = lane_of(jobs[lane]->pose, quad * quad_bones);
      const bool moves = is_in(quads_of_packet(displaced, quad / packet_quads), quad % packet_quads);
      for (int part = 0; part < rigid_components; ++part) {
        FourVectors<V> loaded{hn::Zero(D()), hn::Zero(D()), hn::Zero(D()), hn::Zero(D())};
        if (part < 4 || moves) loaded = load_four_bones(D(), from, part * packet_bones);
        for (int joint = first; joint < end; ++joint) {
          joints[joint][part].store(D(), loaded.v[bones[joint] % quad_bones]);
        }
      }
    }
  }
  void load_gaze(const LookAtJob& job, int lane) {
    for (int axis = 0; axis < 3; ++axis) target[axis].of[lane] = job.target[axis];
    weight.of[lane] = job.weight;
    seconds.of[lane] = job.seconds;
    most_yaw.of[lane] = job.limits.yaw;
    most_up.of[lane] = job.limits.pitch_up;
    most_down.of[lane] = job.limits.pitch_down;
    smooth_seconds.of[lane] = job.limits.smooth_seconds;
    started.of[lane] = job.state->started ? 1.0F : 0.0F;
    yaw.of[lane] = job.state->yaw.value;
    yaw_velocity.of[lane] = job.state->yaw.velocity;
    pitch.of[lane] = job.state->pitch.value;
    pitch_velocity.of[lane] = job.state->pitch.velocity;
  }
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
