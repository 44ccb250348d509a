#include "engine/anim/asset/root_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

glm::dvec3 turned(const glm::dvec3& v, double yaw) {
  if (yaw == 0.0) return v;  // most clips never turn, and rounding of sines must not touch them
  const double c = cosine(yaw);
  const double s = sine(yaw);
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

RootMotion motion_to(const RootKey& key) { return {.translation = {key.x, key.y, key.z}, .yaw = key.yaw}; }

/// Returns the motion from one key to the next, seen from the first.
RootMotion motion_along(const Segment& segment) {
  return compose(inverse(motion_to(*segment.from)), motion_to(*segment.to));
}

RootMotion motion_at(const RootCurve& curve, FineTicks position) {
  const Segment segment = segment_at(curve, position);
  const auto [from, to, fraction] = segment;
  if (from->yaw != to->yaw) {
    return compose(motion_to(*from), moved_by(steady_velocity(motion_along(segment), 1.0), fraction));
  }
  const auto between = [part = fraction](double a, double b) { return a + (b - a) * part; };
  return {.translation = {between(from->x, to->x), between(from->y, to->y), between(from->z, to->z)}, .yaw = from->yaw};
}

/// Returns the chord of an arc of half that angle over the arc's length.
double chord_share(double half) { return std::abs(half) < 1e-8 ? 1.0 : sine(half) / half; }

/// Scales the motion over the ground, and not the climb.
glm::dvec3 scaled_on_ground(const glm::dvec3& v, double scale) { return {v.x * scale, v.y, v.z * scale}; }

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
  const double one = sine(half);
  const double steps = one == 0.0 ? times : sine(times * half) / one;
  RootMotion repeated{.translation = turned(motion.translation * steps, (times - 1.0) * half),
                      .yaw = motion.yaw * times};
  repeated.translation.y = motion.translation.y * times;
  return repeated;
}

RootMotion moved_by(const RootVelocity& velocity, double seconds) {
  const double half = 0.5 * velocity.yaw * seconds;
  const glm::dvec3 along = velocity.linear * seconds;
  return {.translation = turned(scaled_on_ground(along, chord_share(half)), half), .yaw = velocity.yaw * seconds};
}

RootVelocity steady_velocity(const RootMotion& motion, double seconds) {
  const double half = 0.5 * motion.yaw;
  const glm::dvec3 along = turned(scaled_on_ground(motion.translation, 1.0 / chord_share(half)), -half);
  return {.linear = along / seconds, .yaw = motion.yaw / seconds};
}

RootCurve straight_root_curve(Ticks duration, const glm::dvec3& translation) {
  RootCurve curve{.duration = duration, .keys = {}};
  if (duration <= Ticks{} || translation == glm::dvec3(0.0)) return curve;
  curve.keys = {RootKey{}, RootKey{.time = duration, .x = translation.x, .y = translation.y, .z = translation.z}};
  return curve;
}

// Keys lie an eighth of a turn apart at most, since the way along an arc is told by its ends.
RootCurve steady_root_curve(Ticks duration, const RootVelocity& velocity) {
  const double turn = std::abs(velocity.yaw) * to_seconds(duration);
  const auto arcs = static_cast<std::int64_t>(std::ceil(turn / (0.25 * std::numbers::pi)));
  if (arcs == 0) return straight_root_curve(duration, velocity.linear * to_seconds(duration));
  RootCurve curve{.duration = duration, .keys = {RootKey{}}};
  for (std::int64_t i = 1; i <= arcs; ++i) {
    const Ticks time = duration * i / arcs;
    const RootMotion there = moved_by(velocity, to_seconds(time));
    const glm::dvec3& place = there.translation;
    curve.keys.push_back({.time = time, .x = place.x, .y = place.y, .z = place.z, .yaw = there.yaw});
  }
  return curve;
}

RootMotion whole_motion(const RootCurve& curve) {
  return curve.keys.empty() ? RootMotion{} : motion_to(curve.keys.back());
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
  const Segment segment = segment_at(curve, position);
  const RootKey &from = *segment.from, &to = *segment.to;
  const double seconds = to_seconds(to.time - from.time);
  if (from.yaw != to.yaw) return steady_velocity(motion_along(segment), seconds);
  const glm::dvec3 moved(to.x - from.x, to.y - from.y, to.z - from.z);
  return {.linear = turned(moved / seconds, -from.yaw), .yaw = 0.0};
}

}  // namespace throng::anim
