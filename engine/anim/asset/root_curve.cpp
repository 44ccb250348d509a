#include "engine/anim/asset/root_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "engine/anim/asset/data_keys.h"

namespace throng::anim {

namespace {

glm::dvec3 turned(const glm::dvec3& v, double yaw) {
  if (yaw == 0.0) return v;  // most clips never turn, and rounding of sines must not touch them
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {v.x * c + v.z * s, v.y, v.z * c - v.x * s};
}

/// The keys at both ends of the segment that holds `position`, and the fraction of the way between them.
struct Segment {
  const RootKey* from;
  const RootKey* to;
  double fraction;
};

Segment segment_at(const RootCurve& curve, FineTicks position) {
  const auto time = [](const RootKey& key) { return key.time * fine_ticks_per_tick; };
  const auto after = std::ranges::upper_bound(curve.keys, position, {}, time);
  const auto to = std::clamp(after, curve.keys.begin() + 1, curve.keys.end() - 1);
  const auto from = to - 1;
  const double fraction = static_cast<double>(position - time(*from)) / static_cast<double>(time(*to) - time(*from));
  return {.from = &*from, .to = &*to, .fraction = fraction};
}

RootMotion motion_at(const RootCurve& curve, FineTicks position) {
  const auto [from, to, fraction] = segment_at(curve, position);
  const auto between = [part = fraction](double a, double b) { return a + (b - a) * part; };
  return {.translation = {between(from->x, to->x), 0.0, between(from->z, to->z)}, .yaw = between(from->yaw, to->yaw)};
}

RootMotion whole_motion(const RootCurve& curve) {
  const RootKey& last = curve.keys.back();
  return {.translation = {last.x, 0.0, last.z}, .yaw = last.yaw};
}

}  // namespace

RootMotion compose(const RootMotion& first, const RootMotion& second) {
  return {.translation = first.translation + turned(second.translation, first.yaw), .yaw = first.yaw + second.yaw};
}

RootMotion inverse(const RootMotion& motion) {
  return {.translation = -turned(motion.translation, -motion.yaw), .yaw = -motion.yaw};
}

RootMotion power(const RootMotion& motion, double times) {
  // The sum of the turned steps is a geometric series. Whole turns are left out of it, since they would give 0 / 0.
  const double half = 0.5 * std::remainder(motion.yaw, 2.0 * std::numbers::pi);
  const double sine = std::sin(half);
  const double steps = sine == 0.0 ? times : std::sin(times * half) / sine;
  return {.translation = turned(motion.translation * steps, (times - 1.0) * half), .yaw = motion.yaw * times};
}

RootCurve straight_root_curve(Ticks duration, const glm::dvec3& translation) {
  assert(translation.y == 0.0);
  RootCurve curve{.duration = duration, .keys = {}};
  if (duration <= Ticks{} || translation == glm::dvec3(0.0)) return curve;
  curve.keys = {RootKey{}, RootKey{.time = duration, .x = translation.x, .z = translation.z}};
  return curve;
}

RootMotion displacement(const RootCurve& curve, FineTicks from, FineTicks to, bool looping) {
  if (curve.keys.size() < 2 || from == to) return {};
  const FineTicks length = curve.duration * fine_ticks_per_tick;
  if (!looping) {
    const auto held = [&](FineTicks position) { return std::clamp(position, FineTicks{0}, length); };
    return compose(inverse(motion_at(curve, held(from))), motion_at(curve, held(to)));
  }
  const FineTicks from_loop = whole_loops(from, length);
  const FineTicks to_loop = whole_loops(to, length);
  const RootMotion loops = power(whole_motion(curve), static_cast<double>(to_loop - from_loop));
  return compose(inverse(motion_at(curve, from - from_loop * length)),
                 compose(loops, motion_at(curve, to - to_loop * length)));
}

RootVelocity root_velocity(const RootCurve& curve, FineTicks position) {
  if (curve.keys.size() < 2) return {};
  const auto [from, to, fraction] = segment_at(curve, position);
  const double seconds = to_seconds(to->time - from->time);
  const double yaw = from->yaw + (to->yaw - from->yaw) * fraction;
  const glm::dvec3 moved(to->x - from->x, 0.0, to->z - from->z);
  return {.linear = turned(moved / seconds, -yaw), .yaw = (to->yaw - from->yaw) / seconds};
}

}  // namespace throng::anim
