#include "app/people/crowd/steering/step_strip.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "engine/base/simd_targets.h"
// After simd_targets.h, which says what Highway compiles for.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "app/people/crowd/steering/step_strip.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that this is compiled for.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace throng::app::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, StepStrip::lanes>;
using Numbers = hn::RebindToUnsigned<Floats>;
using Vector = hn::Vec<Floats>;
using Mask = hn::Mask<Floats>;
constexpr Floats d{};
constexpr Numbers numbers{};

constexpr float avoidance = 1.6F;       // of the wished speed, at the strongest
constexpr float sidestep = 0.6F;        // of the speed that is lost
constexpr float follow_seconds = 0.4F;  // in which the gap to the one ahead may close
constexpr float acceleration = 3.5F;    // metres a second squared, for a person 1.8 m tall
constexpr float braking = 7.0F;
constexpr float most_turning = 1.2F;  // of the wished speed
constexpr float to_the_right = 0.1F, to_the_right_head_on = 0.35F;

struct Vector2 {
  Vector x, z;
};

HWY_INLINE Vector all(float value) { return hn::Set(d, value); }
HWY_INLINE Vector2 operator+(Vector2 a, Vector2 b) { return {hn::Add(a.x, b.x), hn::Add(a.z, b.z)}; }
HWY_INLINE Vector2 operator-(Vector2 a, Vector2 b) { return {hn::Sub(a.x, b.x), hn::Sub(a.z, b.z)}; }
HWY_INLINE Vector2 operator*(Vector2 a, Vector scale) { return {hn::Mul(a.x, scale), hn::Mul(a.z, scale)}; }
HWY_INLINE Vector dot(Vector2 a, Vector2 b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.z, b.z)); }
HWY_INLINE Vector squared(Vector2 a) { return dot(a, a); }
HWY_INLINE Vector length(Vector2 a) { return hn::Sqrt(squared(a)); }
HWY_INLINE Vector2 right_of(Vector2 forward) { return {hn::Neg(forward.z), forward.x}; }
HWY_INLINE Vector2 if_else(Mask mask, Vector2 yes, Vector2 no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE Vector2 if_else_zero(Mask mask, Vector2 yes) {
  return {hn::IfThenElseZero(mask, yes.x), hn::IfThenElseZero(mask, yes.z)};
}
HWY_INLINE Vector at_least_zero(Vector value) { return hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value); }

HWY_INLINE Vector2 with_length(Vector2 vector, Vector wanted) {
  const Vector square = squared(vector);
  return if_else_zero(hn::Gt(square, hn::Zero(d)), vector * hn::Div(wanted, hn::Sqrt(square)));
}

HWY_INLINE Vector2 no_longer_than(Vector2 vector, Vector most) {
  return if_else(hn::Gt(squared(vector), hn::Mul(most, most)), with_length(vector, most), vector);
}

/// The walkers of the lanes from one on, as many as a vector has.
struct Walkers {
  Vector2 position, velocity, wish;
  Vector radius, wished_speed;

  Walkers(const StepStrip& strip, std::size_t lane)
      : position{hn::Load(d, &strip.x[lane]), hn::Load(d, &strip.z[lane])},
        velocity{hn::Load(d, &strip.velocity_x[lane]), hn::Load(d, &strip.velocity_z[lane])},
        wish{hn::Load(d, &strip.wish_x[lane]), hn::Load(d, &strip.wish_z[lane])},
        radius(hn::Load(d, &strip.radius[lane])),
        wished_speed(length(wish)) {}

  Vector2 wish_with_length(Vector wanted) const {
    return if_else_zero(hn::Gt(wished_speed, hn::Zero(d)), wish * hn::Div(wanted, wished_speed));
  }
};

/// One body for each lane.
struct Others {
  Vector2 position, velocity;
  Vector radius, share_of_gap;
  Mask is_company;

  template <typename Indices>
  Others(const BodyColumns& columns, Indices places, hn::Vec<Numbers> company)
      : position{hn::GatherIndex(d, columns.x.data(), places), hn::GatherIndex(d, columns.z.data(), places)},
        velocity{hn::GatherIndex(d, columns.velocity_x.data(), places),
                 hn::GatherIndex(d, columns.velocity_z.data(), places)},
        radius(hn::GatherIndex(d, columns.radius.data(), places)),
        share_of_gap(hn::GatherIndex(d, columns.share_of_gap.data(), places)),
        is_company(hn::RebindMask(d, hn::Eq(hn::GatherIndex(numbers, columns.company.data(), places), company))) {}
};

/// Returns the turn away from the other's place at the closest approach; it is larger the sooner and closer that is.
HWY_INLINE Vector2 avoid(const Walkers& self, const Others& other, Vector2 apart, Vector radii, Vector passing,
                         Mask seen) {
  const Vector2 relative = other.velocity - self.wish;
  const Vector speed_squared = squared(relative);
  const Vector closing = hn::Neg(dot(apart, relative));
  const Mask comes =
      hn::And(hn::Gt(closing, hn::Zero(d)), hn::Lt(closing, hn::Mul(all(steering_horizon), speed_squared)));
  const Vector time = hn::Div(closing, speed_squared);
  const Vector2 miss = apart + relative * time;
  const Mask turns = hn::And(hn::And(seen, comes), hn::Lt(squared(miss), hn::Mul(passing, passing)));
  const Mask head_on = hn::Le(dot(other.velocity, self.wish), hn::Zero(d));
  const Vector2 right = right_of(self.wish_with_length(radii));
  const Vector2 away = right * hn::IfThenElse(head_on, all(to_the_right_head_on), all(to_the_right)) - miss;
  const Vector soon = hn::Sub(all(1.0F), hn::Div(time, all(steering_horizon)));
  const Vector close = hn::Sub(all(1.0F), hn::Div(length(miss), passing));
  const Vector strength = hn::Mul(hn::Mul(hn::Mul(hn::Mul(all(avoidance), self.wished_speed), close), soon), soon);
  return if_else_zero(turns, with_length(away, strength));
}

/// The limits that one body for each lane is to the lane's walker.
struct Limits {
  Vector2 towards;
  Vector soft, hard;
};

HWY_INLINE Limits limits_of(const Others& other, Vector2 apart, Vector distance, Vector polite, Vector least,
                            Vector seconds) {
  const Vector2 towards =
      if_else_zero(hn::Gt(distance, hn::Zero(d)), {hn::Div(apart.x, distance), hn::Div(apart.z, distance)});
  const Vector lead = at_least_zero(dot(other.velocity, towards));
  const Vector to_polite = hn::Mul(other.share_of_gap, hn::Sub(distance, polite));
  const Vector to_least = hn::Mul(other.share_of_gap, hn::Sub(distance, least));
  return {.towards = towards,
          .soft = hn::Add(lead, hn::Div(to_polite, all(follow_seconds))),
          .hard = at_least_zero(hn::Div(to_least, seconds))};
}

/// Keeps the limits of the lanes in `mask`, below the former limits of each lane.
HWY_INLINE void keep(const Limits& limits, Mask mask, std::size_t first_lane, StepStrip& strip) {
  alignas(64) StepStrip::Floats x, z, soft, hard;
  hn::Store(limits.towards.x, d, x.data());
  hn::Store(limits.towards.z, d, z.data());
  hn::Store(limits.soft, d, soft.data());
  hn::Store(limits.hard, d, hard.data());
  alignas(64) StepStrip::Floats is_limit;
  hn::Store(hn::IfThenElseZero(mask, all(1.0F)), d, is_limit.data());
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (is_limit[i] == 0.0F) continue;
    const std::size_t lane = first_lane + i;
    const std::uint32_t row = strip.limit_count[lane];
    strip.limit_count[lane] = std::min(row + 1, StepStrip::most_limits + 1);
    if (row >= StepStrip::most_limits) continue;
    if (row == strip.limit_rows) {
      ++strip.limit_rows;
      strip.towards_x[row].fill(0.0F);
      strip.towards_z[row].fill(0.0F);
      strip.soft[row].fill(std::numeric_limits<float>::infinity());
      strip.hard[row].fill(std::numeric_limits<float>::infinity());
    }
    strip.towards_x[row][lane] = x[i];
    strip.towards_z[row][lane] = z[i];
    strip.soft[row][lane] = soft[i];
    strip.hard[row][lane] = hard[i];
  }
}

void see_lanes(const SeeJob& job, std::size_t lane, StepStrip& strip) {
  const Walkers self(strip, lane);
  const KeptDistances& keeps = job.keeps;
  const auto company = hn::Load(numbers, &strip.company[lane]);
  const auto own = keeps.are_agents ? hn::Load(numbers, &strip.place[lane]) : hn::Set(numbers, StepStrip::nowhere);
  const auto counts = hn::Load(numbers, &job.found->count[lane]);
  Vector2 turn{hn::Load(d, &strip.turn_x[lane]), hn::Load(d, &strip.turn_z[lane])};
  for (std::uint32_t k = 0; !hn::AllFalse(numbers, hn::Gt(counts, hn::Set(numbers, k))); ++k) {
    const auto has_one = hn::Gt(counts, hn::Set(numbers, k));
    const auto places = hn::IfThenElseZero(has_one, hn::Load(numbers, &job.found->places[k][lane]));
    const Others other(*job.bodies, hn::BitCast(hn::RebindToSigned<Floats>(), places), company);
    const Vector2 apart = other.position - self.position;
    const Vector square = squared(apart);
    const Vector sight = hn::Add(all(job.rules.sight), hn::Mul(all(keeps.sight_per_radius), other.radius));
    const Mask is_other = hn::RebindMask(d, hn::AndNot(hn::Eq(places, own), has_one));
    const Mask seen = hn::And(is_other, hn::Le(square, hn::Mul(sight, sight)));
    const Mask is_polite = keeps.are_agents ? hn::AndNot(other.is_company, seen) : seen;
    const Vector radii = hn::Add(self.radius, other.radius);
    const Vector passing =
        hn::Mul(all(keeps.passing_scale), hn::Add(hn::Mul(all(keeps.passing_per_radius), self.radius), other.radius));
    turn = turn + avoid(self, other, apart, radii, passing, is_polite);
    const Vector close = hn::Add(radii, all(job.rules.closing));
    const Mask is_close = hn::And(seen, hn::Lt(square, hn::Mul(close, close)));
    if (hn::AllFalse(d, is_close)) continue;
    const Vector least = hn::Mul(all(keeps.least_share_of_radii), radii);
    keep(limits_of(other, apart, hn::Sqrt(square), radii, least, all(job.rules.seconds)), is_close, lane, strip);
  }
  hn::Store(turn.x, d, &strip.turn_x[lane]);
  hn::Store(turn.z, d, &strip.turn_z[lane]);
}

/// The rows of limits of the lanes from one on.
class Rows {
 public:
  Rows(const StepStrip& strip, std::size_t lane) : strip_(&strip), lane_(lane) {}

  std::uint32_t count() const { return strip_->limit_rows; }
  Vector2 towards(std::uint32_t row) const {
    return {hn::Load(d, &strip_->towards_x[row][lane_]), hn::Load(d, &strip_->towards_z[row][lane_])};
  }
  Vector soft(std::uint32_t row) const { return hn::Load(d, &strip_->soft[row][lane_]); }
  Vector hard(std::uint32_t row) const { return hn::Load(d, &strip_->hard[row][lane_]); }

 private:
  const StepStrip* strip_;
  std::size_t lane_;
};

/// Takes off what is over each limit, one after the other. A lane over no limit stays as it is in further passes.
template <typename Most>
HWY_INLINE Vector2 cut(const Rows& rows, Vector2 velocity, const Most& most, int passes) {
  bool is_over = true;
  for (int pass = 0; pass < passes && is_over; ++pass) {
    is_over = false;
    for (std::uint32_t row = 0; row < rows.count(); ++row) {
      const Vector2 towards = rows.towards(row);
      const Vector over = hn::Sub(dot(velocity, towards), most(row));
      const Mask cuts = hn::Gt(over, hn::Zero(d));
      if (hn::AllFalse(d, cuts)) continue;
      velocity = if_else(cuts, velocity - towards * over, velocity);
      is_over = true;
    }
  }
  return velocity;
}

HWY_INLINE Vector2 politely(const Rows& rows, Vector2 velocity) {
  return cut(
      rows, velocity, [&](std::uint32_t row) { return rows.soft(row); }, 3);
}

HWY_INLINE Vector2 kept_apart(const Rows& rows, Vector2 velocity) {
  velocity = cut(
      rows, velocity, [&](std::uint32_t row) { return rows.hard(row); }, 2);
  Vector kept = all(1.0F);  // standing still is within every limit, so some part of the way there is too
  for (std::uint32_t row = 0; row < rows.count(); ++row) {
    const Vector speed = dot(velocity, rows.towards(row)), hard = rows.hard(row);
    const Vector part = hn::Div(hard, speed);
    kept = hn::IfThenElse(hn::And(hn::Gt(speed, hard), hn::Lt(part, kept)), part, kept);
  }
  return velocity * kept;
}

HWY_INLINE Vector2 velocity_of(const StepRules& rules, const StepStrip& strip, std::size_t lane, const Walkers& self) {
  const Rows rows(strip, lane);
  const Vector2 turn{hn::Load(d, &strip.turn_x[lane]), hn::Load(d, &strip.turn_z[lane])};
  Vector2 velocity = self.wish + no_longer_than(turn, hn::Mul(all(most_turning), self.wished_speed));
  velocity = politely(rows, no_longer_than(velocity, hn::Load(d, &strip.most_speed[lane])));
  // An agent that is held up tries its right.
  const Vector held_up = hn::Sub(self.wished_speed, dot(velocity, self.wish_with_length(all(1.0F))));
  const Mask tries = hn::Gt(held_up, hn::Mul(all(0.5F), self.wished_speed));
  if (!hn::AllFalse(d, tries)) {
    const Vector2 aside = right_of(self.wish_with_length(hn::Mul(all(sidestep), held_up)));
    velocity = if_else(tries, politely(rows, velocity + aside), velocity);
  }
  const Mask brakes = hn::Lt(squared(velocity), squared(self.velocity));
  const Vector rate = hn::IfThenElse(brakes, all(braking), all(acceleration));
  const Vector change = hn::Mul(hn::Mul(rate, all(rules.spacing)), all(rules.seconds));
  velocity = self.velocity + no_longer_than(velocity - self.velocity, change);
  velocity = kept_apart(rows, no_longer_than(velocity, all(rules.most_speed)));
  const auto is_crowded = hn::Gt(hn::Load(numbers, &strip.limit_count[lane]), hn::Set(numbers, StepStrip::most_limits));
  return if_else(hn::RebindMask(d, is_crowded), {hn::Zero(d), hn::Zero(d)}, velocity);
}

}  // namespace

void see_in_lanes(const SeeJob& job, StepStrip& strip) {
  for (std::size_t lane = 0; lane < strip.count; lane += hn::Lanes(d)) see_lanes(job, lane, strip);
}

void step_in_lanes(const StepRules& rules, StepStrip& strip) {
  for (std::size_t lane = 0; lane < strip.count; lane += hn::Lanes(d)) {
    const Walkers self(strip, lane);
    const Vector2 velocity = velocity_of(rules, strip, lane, self);
    const Vector2 position = self.position + velocity * all(rules.seconds);
    hn::Store(velocity.x, d, &strip.velocity_x[lane]);
    hn::Store(velocity.z, d, &strip.velocity_z[lane]);
    hn::Store(position.x, d, &strip.x[lane]);
    hn::Store(position.z, d, &strip.z[lane]);
  }
}

}  // namespace throng::app::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::app {

HWY_EXPORT(see_in_lanes);
HWY_EXPORT(step_in_lanes);

bool is_valid(const SeeJob& job, const StepStrip& strip) {
  if (job.bodies == nullptr || job.found == nullptr || strip.count > StepStrip::lanes) return false;
  const auto is_beyond = [&](std::uint32_t count) { return count > NearBodies::most; };
  return job.rules.seconds > 0.0F && std::ranges::none_of(job.found->count, is_beyond);
}

void see(const SeeJob& job, StepStrip& strip) {
  assert(is_valid(job, strip));
  HWY_DYNAMIC_DISPATCH(see_in_lanes)(job, strip);
}

void take_step(const StepRules& rules, StepStrip& strip) {
  assert(rules.seconds > 0.0F && strip.count <= StepStrip::lanes);
  HWY_DYNAMIC_DISPATCH(step_in_lanes)(rules, strip);
}

}  // namespace throng::app
#endif  // HWY_ONCE
