// What gazes read and write of their characters, a character a lane.
#if defined(THRONG_KERNEL_LOOK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LOOK_LANES_INL_H
#undef THRONG_KERNEL_LOOK_LANES_INL_H
#else
#define THRONG_KERNEL_LOOK_LANES_INL_H
#endif

#include <cstddef>
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
    load_poses(rig);
  }
  void store() const {
    store_gazes();
    for (int quad = 0; quad < turning_quads_; ++quad) store_rotations(quads_[quad]);
  }

  Quaternions<V> rotation(D d, int joint) const {
    const Lane<D>* parts = joints_[joint];
    return {parts[0].load(d), parts[1].load(d), parts[2].load(d), parts[3].load(d)};
  }
  /// From the joint before, in its frame.
  Vectors<V> offset(D d, const JointChain& chain, int joint) const {
    const Vectors<V> bound = broadcast_vector(d, &chain.offsets.data()[joint].x);
    const Lane<D>* parts = joints_[joint] + 4;
    return sum(bound, Vectors<V>{parts[0].load(d), parts[1].load(d), parts[2].load(d)});
  }
  /// Of LookAtRig::joints[looking].
  void turn(D d, int looking, const Quaternions<V>& rotation) {
    Lane<D>* const parts = turning_[looking];
    parts[0].store(d, rotation.x);
    parts[quad_bones].store(d, rotation.y);
    parts[2 * quad_bones].store(d, rotation.z);
    parts[3 * quad_bones].store(d, rotation.w);
  }

 private:
  static constexpr int lanes = lane_count<D>;

  /// Rotations of four bones that lie side by side in a packet, and are read and written together.
  struct Quad {
    int bone;  ///< the first
    Lane<D> parts[4 * quad_bones];
  };

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
  /// Floats that lie side by side, from first_of(job) on.
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

  float* lane_of(int job, int bone) const { return jobs_[job]->pose.packet(bone / packet_bones) + bone % packet_bones; }
  /// Quad by quad of the chain; positions of those that nobody displaces are not read.
  void load_poses(const LookAtRig& rig) {
    const auto* const bones = rig.chain.bones.data();
    std::uint64_t displaced = 0;
    for (int lane = 0; lane < lanes; ++lane) displaced |= jobs_[lane]->pose.displaced_quads;
    turning_quads_ = 0;
    for (int first = 0, end = 0, looking = 0; first < rig.chain.count; first = end) {
      const int index = bones[first] / quad_bones;
      for (end = first + 1; end < rig.chain.count && bones[end] / quad_bones == index;) ++end;
      const bool moves = is_in(quads_of_packet(displaced, index / packet_quads), index % packet_quads);
      Quad& quad = quads_[turning_quads_];
      quad.bone = index * quad_bones;
      load_quad(quad, bones, first, end, moves);
      const int before = looking;
      for (; looking < rig.joint_count && rig.joints.data()[looking] < end; ++looking) {
        turning_[looking] = quad.parts + bones[rig.joints.data()[looking]] % quad_bones;
      }
      if (looking > before) ++turning_quads_;
    }
  }
  /// Of joints [first, end), whose bones it has.
  void load_quad(Quad& quad, const std::int16_t* bones, int first, int end, bool moves) {
    const D d;
    const float* from[lane_count<D>];
    for (int lane = 0; lane < lanes; ++lane) from[lane] = lane_of(lane, quad.bone);
    FourVectors<V> rotations[4];
    load_rows_of_four<4>(d, from, 0, packet_bones, rotations);
    for (int part = 0; part < 4; ++part) {
      for (int bone = 0; bone < quad_bones; ++bone)
        quad.parts[part * quad_bones + bone].store(d, rotations[part].v[bone]);
    }
    for (int joint = first; joint < end; ++joint) {
      const Lane<D>* const parts = quad.parts + bones[joint] % quad_bones;
      for (int part = 0; part < 4; ++part) joints_[joint][part].store(d, parts[part * quad_bones].load(d));
    }
    const V zero = hn::Zero(d);
    FourVectors<V> positions[3] = {{{zero, zero, zero, zero}}, {{zero, zero, zero, zero}}, {{zero, zero, zero, zero}}};
    if (moves) load_rows_of_four<3>(d, from, 4 * packet_bones, packet_bones, positions);
    for (int joint = first; joint < end; ++joint) {
      const int bone = bones[joint] % quad_bones;
      for (int axis = 0; axis < 3; ++axis) joints_[joint][4 + axis].store(d, positions[axis].v[bone]);
    }
  }
  /// Those of bones that do not look are what they were.
  void store_rotations(const Quad& quad) const {
    const D d;
    float* to[lane_count<D>];
    for (int lane = 0; lane < lanes; ++lane) to[lane] = lane_of(lane, quad.bone);
    FourVectors<V> rotations[4];
    for (int part = 0; part < 4; ++part) {
      const Lane<D>* const bones = quad.parts + part * quad_bones;
      rotations[part] = {{bones[0].load(d), bones[1].load(d), bones[2].load(d), bones[3].load(d)}};
    }
    store_rows_of_four<4>(d, rotations, to, packet_bones);
  }

  const LookAtJob* jobs_[lane_count<D>];
  Lane<D> joints_[JointChain::max_joints][rigid_components];
  Quad quads_[max_look_joints + 1];    ///< those with looking joints, then room for one without
  Lane<D>* turning_[max_look_joints];  ///< of a looking joint in its quad, the first part
  int turning_quads_;
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
