// The locks of foot_lock.h, one foot a lane.
#if defined(THRONG_KERNEL_FOOT_LOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_FOOT_LOCK_INL_H
#undef THRONG_KERNEL_FOOT_LOCK_INL_H
#else
#define THRONG_KERNEL_FOOT_LOCK_INL_H
#endif

#include "engine/anim/kernel/lanes/directions-inl.h"
#include "engine/anim/kernel/lanes/transpose-inl.h"
#include "engine/anim/kernel/limb/foot_lock.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// A foot is planted from this value on, 0 to 1.
inline constexpr float planted_from = 0.5F;

/// Footing, foot_lock.h.
template <class V>
struct Footings {
  Vectors<V> place, normal;
};

template <class D>
struct FootLockOptionLanes {
  hn::Vec<D> release_seconds, farthest;
  hn::Mask<D> enabled;
};

template <class D, class V>
HWY_INLINE Vectors<V> upwards(D d, V length) {
  return {hn::Zero(d), length, hn::Zero(d)};
}

template <class D>
HWY_INLINE hn::Mask<D> has_flag(D d, hn::Vec<D> flags, std::uint32_t flag) {
  const hn::RebindToUnsigned<D> bits;
  return hn::RebindMask(d, hn::TestBit(hn::BitCast(bits, flags), hn::Set(bits, flag)));
}

template <class D>
HWY_INLINE hn::Vec<D> flag_where(D d, hn::Mask<D> where, std::uint32_t flag) {
  const hn::RebindToUnsigned<D> bits;
  return hn::IfThenElseZero(where, hn::BitCast(d, hn::Set(bits, flag)));
}

/// FootLock.
template <class D>
struct FootLocks {
  using V = hn::Vec<D>;

  Vectors<V> place, normal, offset, last_ball;
  V released_for, slid, standing_seconds;
  hn::Mask<D> locked, overstretched, standing, stepping;

  void load(D d, const FourVectors<V>* rows) {
    const auto vector_of = [&](int row) { return Vectors<V>{rows[row].v[0], rows[row].v[1], rows[row].v[2]}; };
    place = vector_of(0);
    released_for = rows[0].v[3];
    normal = vector_of(1);
    slid = rows[1].v[3];
    offset = vector_of(2);
    standing_seconds = rows[2].v[3];
    last_ball = vector_of(3);
    locked = has_flag(d, rows[3].v[3], FootLock::is_locked);
    overstretched = has_flag(d, rows[3].v[3], FootLock::is_overstretched);
    standing = has_flag(d, rows[3].v[3], FootLock::is_standing);
    stepping = has_flag(d, rows[3].v[3], FootLock::is_stepping);
  }
  void store(D d, FourVectors<V>* rows) const {
    const V flags =
        hn::Or(hn::Or(flag_where(d, locked, FootLock::is_locked), flag_where(d, stepping, FootLock::is_stepping)),
               hn::Or(flag_where(d, overstretched, FootLock::is_overstretched),
                      flag_where(d, standing, FootLock::is_standing)));
    rows[0] = {{place.x, place.y, place.z, released_for}};
    rows[1] = {{normal.x, normal.y, normal.z, slid}};
    rows[2] = {{offset.x, offset.y, offset.z, standing_seconds}};
    rows[3] = {{last_ball.x, last_ball.y, last_ball.z, flags}};
  }
};

/// Height of the plane through a footing at (x, z).
template <class V>
HWY_INLINE V ground_height(const Footings<V>& footing, V x, V z) {
  const V aside = hn::Mul(hn::Sub(x, footing.place.x), footing.normal.x);
  const V rise = hn::MulAdd(hn::Sub(z, footing.place.z), footing.normal.z, aside);
  return hn::Sub(footing.place.y, hn::Div(rise, footing.normal.y));
}

template <class V>
HWY_INLINE V horizontal_distance(const Vectors<V>& a, const Vectors<V>& b) {
  const V x = hn::Sub(a.x, b.x);
  const V z = hn::Sub(a.z, b.z);
  return hn::Sqrt(hn::MulAdd(z, z, hn::Mul(x, x)));
}

/// Falls from 1 at the release to 0 after release_seconds, smoothly at both ends.
template <class D, class V>
HWY_INLINE V fading(D d, V released_for, V release_seconds) {
  const V one = hn::Set(d, 1.0F);
  const V part = hn::Min(hn::Div(released_for, release_seconds), one);
  const V t = hn::IfThenElse(hn::Gt(release_seconds, hn::Zero(d)), part, one);
  return hn::NegMulAdd(hn::Mul(t, t), hn::NegMulAdd(hn::Set(d, 2.0F), t, hn::Set(d, 3.0F)), one);
}

template <class D, class V>
HWY_INLINE Footings<V> free_footing(D d, const FootLocks<D>& lock, const Footings<V>& posed, V release_seconds) {
  const V one = hn::Set(d, 1.0F);
  const V fade = fading(d, lock.released_for, release_seconds);
  const V x = hn::MulAdd(lock.offset.x, fade, posed.place.x);
  const V z = hn::MulAdd(lock.offset.z, fade, posed.place.z);
  const Vectors<V> easing{x, hn::MulAdd(lock.offset.y, fade, ground_height(posed, x, z)), z};
  const Vectors<V> between = scaled_add(lock.normal, fade, scaled(posed.normal, hn::Sub(one, fade)));
  const auto eases = hn::Gt(fade, hn::Zero(d));
  return {choose(eases, easing, posed.place), choose(eases, unit_or(d, between, upwards(d, one)), posed.normal)};
}

/// Ends the locks of feet that are lifted, too far from their pose or, as time passes, `short_of` their place: these go
/// from where their legs left them.
template <class D, class V>
HWY_INLINE void let_go(D d, FootLocks<D>& lock, const Footings<V>& posed, hn::Mask<D> planted, hn::Mask<D> short_of,
                       const FootLockOptionLanes<D>& options, V seconds) {
  const auto too_far = hn::Gt(horizontal_distance(lock.place, posed.place), options.farthest);
  const auto gives_way = hn::And(short_of, hn::Gt(seconds, hn::Zero(d)));
  const auto goes = hn::And(lock.locked, hn::Or(hn::Not(planted), hn::Or(too_far, gives_way)));
  const V x = hn::IfThenElse(short_of, lock.last_ball.x, lock.place.x);
  const V z = hn::IfThenElse(short_of, lock.last_ball.z, lock.place.z);
  const V y = hn::IfThenElse(short_of, ground_height(Footings<V>{lock.place, lock.normal}, x, z), lock.place.y);
  const Vectors<V> offset{hn::Sub(x, posed.place.x), hn::Sub(y, ground_height(posed, x, z)), hn::Sub(z, posed.place.z)};
  lock.offset = choose(goes, offset, lock.offset);
  lock.released_for = hn::IfThenZeroElse(goes, lock.released_for);
  lock.overstretched = hn::And(planted, hn::Or(lock.overstretched, hn::And(goes, too_far)));
  lock.stepping = hn::And(planted, hn::Or(lock.stepping, hn::And(goes, gives_way)));
  lock.locked = hn::AndNot(goes, lock.locked);
}

/// Moves the offset of a released foot on: to where its leg left it, and to nothing once its time is over.
template <class D, class V>
HWY_INLINE void bring_back(D d, FootLocks<D>& lock, V reached, V release_seconds, V seconds) {
  const V since = hn::Add(lock.released_for, seconds);
  const auto is_back = hn::AndNot(lock.locked, hn::Ge(since, release_seconds));
  const V kept = hn::IfThenElse(hn::Or(lock.locked, hn::Le(seconds, hn::Zero(d))), hn::Set(d, 1.0F), reached);
  lock.released_for = hn::IfThenElse(lock.locked, lock.released_for, since);
  lock.stepping = hn::AndNot(is_back, lock.stepping);
  lock.offset = {hn::IfThenZeroElse(is_back, hn::Mul(lock.offset.x, kept)), hn::IfThenZeroElse(is_back, lock.offset.y),
                 hn::IfThenZeroElse(is_back, hn::Mul(lock.offset.z, kept))};
}

/// Makes one step and returns the footing to use, world space. `posed` is the footing in the pose; a foot locks from
/// `planted` of planted_from on. `reached` is the share of the way from there to its footing that its leg reached in
/// the last step. The footing never jumps: a foot locks where it is, and its distance from the pose fades out after the
/// release.
template <class D, class V>
HWY_INLINE Footings<V> step_foot_lock(D d, FootLocks<D>& lock, const Footings<V>& posed, V planted, V reached,
                                      const FootLockOptionLanes<D>& options, V seconds) {
  const auto is_planted = hn::And(options.enabled, hn::Ge(planted, hn::Set(d, planted_from)));
  bring_back(d, lock, reached, options.release_seconds, seconds);
  let_go(d, lock, posed, is_planted, hn::Lt(reached, hn::Set(d, 1.0F)), options, seconds);
  const Footings<V> free = free_footing(d, lock, posed, options.release_seconds);
  const auto waits = hn::Or(hn::Or(lock.overstretched, lock.stepping), lock.locked);
  const auto comes_down = hn::AndNot(waits, is_planted);
  lock.locked = hn::Or(lock.locked, comes_down);
  lock.place = choose(comes_down, free.place, lock.place);
  lock.normal = choose(comes_down, free.normal, lock.normal);
  return {choose(lock.locked, lock.place, free.place), choose(lock.locked, lock.normal, free.normal)};
}

/// Returns how high a planted foot steps on its way back from a lock that it was released from, metres. It comes down
/// where the pose has it, and is `least` high in between.
template <class D, class V>
HWY_INLINE V rise_of_step(D d, const FootLocks<D>& lock, V planted, V release_seconds, V least) {
  const V one = hn::Set(d, 1.0F);
  const V fade = fading(d, lock.released_for, release_seconds);
  const V distance = hn::Sqrt(hn::MulAdd(lock.offset.z, lock.offset.z, hn::Mul(lock.offset.x, lock.offset.x)));
  const V highest = hn::Mul(hn::Max(hn::Mul(distance, hn::Set(d, step_height)), least), hn::Set(d, 4.0F));
  const V firmly = hn::Max(hn::MulSub(hn::Set(d, 2.0F), planted, one), hn::Zero(d));
  const auto steps = hn::AndNot(lock.locked, hn::Or(lock.overstretched, lock.stepping));
  return hn::IfThenElseZero(steps, hn::Mul(hn::Mul(highest, firmly), hn::Mul(fade, hn::Sub(one, fade))));
}

/// Adds the distance that the ball of a planted foot moved since the last frame, world space.
template <class D, class V>
HWY_INLINE void measure_slide(D d, FootLocks<D>& lock, const Vectors<V>& ball, V planted, V seconds) {
  const auto is_planted = hn::Ge(planted, hn::Set(d, planted_from));
  const auto comes_down = hn::AndNot(lock.standing, is_planted);
  const auto stands = hn::And(lock.standing, is_planted);
  const V slid = hn::IfThenElseZero(stands, horizontal_distance(ball, lock.last_ball));
  lock.slid = hn::IfThenZeroElse(comes_down, hn::Add(lock.slid, slid));
  lock.standing_seconds =
      hn::IfThenZeroElse(comes_down, hn::Add(lock.standing_seconds, hn::IfThenElseZero(stands, seconds)));
  lock.standing = is_planted;
  lock.last_ball = ball;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
