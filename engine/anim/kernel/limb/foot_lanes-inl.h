// Loads and stores the bodies and feet of a strip, one character a lane.
#if defined(THRONG_KERNEL_FOOT_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_FOOT_LANES_INL_H
#undef THRONG_KERNEL_FOOT_LANES_INL_H
#else
#define THRONG_KERNEL_FOOT_LANES_INL_H
#endif

#include "engine/anim/kernel/lanes/smooth_damp-inl.h"
#include "engine/anim/kernel/limb/chain_lanes-inl.h"
#include "engine/anim/kernel/limb/foot_lock-inl.h"
#include "engine/anim/kernel/limb/foot_placement.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class D>
using FootPlacementJobs = const FootPlacementJob * [lane_count<D>];

/// PlacedBody, with seconds and weight of its job.
template <class D>
struct PlacedBodies {
  using V = hn::Vec<D>;

  JointMotions<V> model_in_world;
  V down_below, up_above, max_drop, drop_smooth_seconds, most_gap, fastest_drop, least_tilt_cosine;
  FootLockOptionLanes<D> lock;
  DampedValues<V> drop;
  V seconds, weight;
  hn::Mask<D> started;

  void load(D d, const FootPlacementJobs<D>& jobs) {
    const float* from[lane_count<D>];
    Lane<D> all_seconds, all_weights, all_started, all_enabled;
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      const FootPlacementJob& job = *jobs[lane];
      from[lane] = reinterpret_cast<const float*>(job.body);
      all_seconds.of[lane] = job.seconds;
      all_weights.of[lane] = job.weight;
      all_started.of[lane] = job.body->started ? 1.0F : 0.0F;
      all_enabled.of[lane] = job.body->options.lock.enabled ? 1.0F : 0.0F;
    }
    FourVectors<V> rows[placed_body_rows];
    load_rows_of_four<placed_body_rows>(d, from, 0, block_floats, rows);
    model_in_world = {{rows[0].v[0], rows[0].v[1], rows[0].v[2], rows[0].v[3]},
                      {rows[1].v[0], rows[1].v[1], rows[1].v[2]}};
    down_below = rows[2].v[0];
    up_above = rows[2].v[1];
    max_drop = rows[2].v[2];
    drop_smooth_seconds = rows[2].v[3];
    most_gap = rows[3].v[0];
    fastest_drop = rows[3].v[1];
    least_tilt_cosine = rows[3].v[2];
    const V zero = hn::Zero(d);
    lock = {rows[3].v[3], rows[4].v[0], hn::Gt(all_enabled.load(d), zero)};
    drop = {rows[4].v[2], rows[4].v[3]};
    seconds = all_seconds.load(d);
    weight = all_weights.load(d);
    started = hn::Gt(all_started.load(d), zero);
  }
  void store(D d, const FootPlacementJobs<D>& jobs) const {
    Lane<D> values, velocities;
    values.store(d, drop.value);
    velocities.store(d, drop.velocity);
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      jobs[lane]->body->drop = {values.of[lane], velocities.of[lane]};
      jobs[lane]->body->started = true;
    }
  }
};

/// PlacedFoot.
template <class D>
struct PlacedFeet {
  using V = hn::Vec<D>;

  Footings<V> ground;
  V planted, missed_by, reached;
  FootLocks<D> lock;
  Vectors<V> ankle;

  void load(D d, const FootPlacementJobs<D>& jobs, int leg) {
    float* from[lane_count<D>];
    find(jobs, leg, from);
    FourVectors<V> grounds[2];
    load_rows_of_four<2>(d, from, 0, block_floats, grounds);
    ground = {{grounds[0].v[0], grounds[0].v[1], grounds[0].v[2]}, {grounds[0].v[3], grounds[1].v[0], grounds[1].v[1]}};
    planted = grounds[1].v[2];
    FourVectors<V> rest[foot_lock_rows + 1];
    load_rows_of_four<foot_lock_rows + 1>(d, from, 2 * block_floats, block_floats, rest);
    lock.load(d, rest);
    reached = rest[foot_lock_rows].v[3];
  }
  /// Stores all but the ground.
  void store(D d, const FootPlacementJobs<D>& jobs, int leg) const {
    float* to[lane_count<D>];
    find(jobs, leg, to);
    for (float*& foot : to) foot += block_floats;
    FourVectors<V> rows[2 + foot_lock_rows];
    rows[0] = {{ground.normal.y, ground.normal.z, planted, missed_by}};
    lock.store(d, rows + 1);
    rows[1 + foot_lock_rows] = {{ankle.x, ankle.y, ankle.z, reached}};
    store_rows_of_four<2 + foot_lock_rows>(d, rows, to, block_floats);
  }

 private:
  static void find(const FootPlacementJobs<D>& jobs, int leg, float* (&feet)[lane_count<D>]) {
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      feet[lane] = reinterpret_cast<float*>(jobs[lane]->feet + leg);
    }
  }
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
