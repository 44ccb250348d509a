// Loads and stores the characters of a look-at strip, one a lane.
#if defined(THRONG_KERNEL_LOOK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LOOK_LANES_INL_H
#undef THRONG_KERNEL_LOOK_LANES_INL_H
#else
#define THRONG_KERNEL_LOOK_LANES_INL_H
#endif

#include <cstddef>
#include <span>

#include "engine/anim/kernel/lanes/angles-inl.h"
#include "engine/anim/kernel/limb/look_at.h"
#include "engine/anim/kernel/pose/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class V>
struct Gazes {
  V yaw, pitch;
};

/// Every lane holds a character. Lanes beyond the last character repeat it.
template <class D>
class LookLanes {
 public:
  using V = hn::Vec<D>;

  Lane<D> target[3], weight, seconds, most_yaw, most_up, most_down, smooth_seconds, started;
  Lane<D> yaw, yaw_velocity, pitch, pitch_velocity, eyes[3], remaining;

  void load(const LookAtRig& rig, std::span<const LookAtJob* const> lookers) {
    for (int lane = 0; lane < lanes; ++lane) {
      jobs_[lane] = lookers[HWY_MIN(static_cast<std::size_t>(lane), lookers.size() - 1)];
    }
    load_gazes();
    const PoseView* poses[lane_count<D>];
    for (int lane = 0; lane < lanes; ++lane) poses[lane] = &jobs_[lane]->pose;
    pose_.begin(poses);
    for (int joint = 0; joint < rig.chain.count; ++joint) bones_[joint] = pose_.place_of(rig.chain.bones.data()[joint]);
  }
  void store() const {
    store_gazes();
    pose_.store();
  }

  Quaternions<V> rotation(D d, int joint) const { return pose_.rotation(d, bones_[joint]); }
  /// The offset from the previous joint, in its frame.
  Vectors<V> offset(D d, const JointChain& chain, int joint) const {
    return sum(broadcast_vector(d, &chain.offsets.data()[joint].x), pose_.position(d, bones_[joint]));
  }
  void turn(D d, int joint, const Quaternions<V>& rotation) { pose_.turn(d, bones_[joint], rotation); }

 private:
  static constexpr int lanes = lane_count<D>;

  static_assert(sizeof(LookAtLimits) == 4 * sizeof(float));
  void load_gazes() {
    load_four(&target[0], &target[1], &target[2], &seconds, [](const LookAtJob& job) { return &job.target.x; });
    load_four(&most_yaw, &most_up, &most_down, &smooth_seconds, [](const LookAtJob& job) { return &job.limits.yaw; });
    load_four(&yaw, &yaw_velocity, &pitch, &pitch_velocity, [](const LookAtJob& job) { return &job.state->yaw.value; });
    load_four(&eyes[0], &eyes[1], &eyes[2], &remaining, [](const LookAtJob& job) { return &job.state->eyes.x; });
    for (int lane = 0; lane < lanes; ++lane) {
      weight.of[lane] = jobs_[lane]->weight;
      started.of[lane] = jobs_[lane]->state->started ? 1.0F : 0.0F;
    }
  }
  /// Loads floats that lie side by side, from first_of(job) on.
  template <class FirstOf>
  void load_four(Lane<D>* a, Lane<D>* b, Lane<D>* c, Lane<D>* last, FirstOf&& first_of) const {
    const float* from[lane_count<D>];
    for (int lane = 0; lane < lanes; ++lane) from[lane] = first_of(*jobs_[lane]);
    FourVectors<V> four;
    load_rows_of_four<1>(D(), from, 0, 0, &four);
    a->store(D(), four.v[0]);
    b->store(D(), four.v[1]);
    c->store(D(), four.v[2]);
    last->store(D(), four.v[3]);
  }
  void store_gazes() const {
    const D d;
    float* to[lane_count<D>];
    for (int lane = 0; lane < lanes; ++lane) to[lane] = &jobs_[lane]->state->yaw.value;
    const FourVectors<V> fours[2] = {{{yaw.load(d), yaw_velocity.load(d), pitch.load(d), pitch_velocity.load(d)}},
                                     {{eyes[0].load(d), eyes[1].load(d), eyes[2].load(d), remaining.load(d)}}};
    store_rows_of_four<2>(d, fours, to, 4);
    for (int lane = 0; lane < lanes; ++lane) jobs_[lane]->state->started = true;
  }

  const LookAtJob* jobs_[lane_count<D>];
  PoseLanes<D, JointChain::max_joints> pose_;
  BonePlace bones_[JointChain::max_joints];
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
