#include "app/people/crowd/steering/near_bodies.h"

#include <algorithm>
#include <cassert>

#include "engine/base/simd_targets.h"
// After simd_targets.h, which says what Highway compiles for.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "app/people/crowd/steering/near_bodies.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that this is compiled for.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace throng::app::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr float margin = 1.0001F;  // of a squared distance: more than roundings can take off it
using Floats = hn::ScalableTag<float>;
using Vector = hn::Vec<Floats>;

/// The numbers of a job in all lanes.
struct Lanes {
  Vector x, z, velocity_x, velocity_z, sight, sight_per_radius, passing_scale, passing_offset, close_offset,
      close_reach, horizon;

  explicit Lanes(const NearBodiesJob& job)
      : x(hn::Set(Floats(), job.position.x)),
        z(hn::Set(Floats(), job.position.y)),
        velocity_x(hn::Set(Floats(), job.velocity.x)),
        velocity_z(hn::Set(Floats(), job.velocity.y)),
        sight(hn::Set(Floats(), job.sight)),
        sight_per_radius(hn::Set(Floats(), job.sight_per_radius)),
        passing_scale(hn::Set(Floats(), job.passing_scale)),
        passing_offset(hn::Set(Floats(), job.passing_offset)),
        close_offset(hn::Set(Floats(), job.close_offset)),
        close_reach(hn::Set(Floats(), job.close_reach)),
        horizon(hn::Set(Floats(), job.horizon)) {}
};

HWY_INLINE Vector squared(Vector x, Vector z) { return hn::Add(hn::Mul(x, x), hn::Mul(z, z)); }

/// Returns which of the bodies from `first` on matter.
HWY_INLINE hn::Mask<Floats> matter(const BodyColumns& columns, std::size_t first, const Lanes& self) {
  const Floats d;
  const Vector radius = hn::LoadU(d, &columns.radius[first]);
  const Vector x = hn::Sub(hn::LoadU(d, &columns.x[first]), self.x);
  const Vector z = hn::Sub(hn::LoadU(d, &columns.z[first]), self.z);
  const Vector square = squared(x, z);
  const Vector sight = hn::Add(self.sight, hn::Mul(self.sight_per_radius, radius));
  const auto in_sight = hn::Le(square, hn::Mul(sight, sight));
  const Vector close = hn::Add(hn::Add(self.close_offset, radius), self.close_reach);
  const auto is_close = hn::Lt(square, hn::Mul(close, close));

  const Vector relative_x = hn::Sub(hn::LoadU(d, &columns.velocity_x[first]), self.velocity_x);
  const Vector relative_z = hn::Sub(hn::LoadU(d, &columns.velocity_z[first]), self.velocity_z);
  const Vector speed_squared = squared(relative_x, relative_z);
  const Vector closing = hn::Neg(hn::Add(hn::Mul(x, relative_x), hn::Mul(z, relative_z)));
  const auto comes_near = hn::And(hn::Gt(closing, hn::Zero(d)), hn::Lt(closing, hn::Mul(self.horizon, speed_squared)));
  // The body passes at |cross| / |relative|; this comparison needs no division.
  const Vector cross = hn::Sub(hn::Mul(x, relative_z), hn::Mul(z, relative_x));
  const Vector passing = hn::Mul(self.passing_scale, hn::Add(self.passing_offset, radius));
  const Vector passing_squared = hn::Mul(hn::Mul(passing, passing), hn::Set(d, margin));
  const auto passes_near = hn::And(comes_near, hn::Lt(hn::Mul(cross, cross), hn::Mul(passing_squared, speed_squared)));
  return hn::And(in_sight, hn::Or(is_close, passes_near));
}

}  // namespace

bool find(const NearBodiesJob& job, NearBodiesCursor& cursor, NearBodies& found) {
  const Floats d;
  const hn::RebindToUnsigned<Floats> numbers;
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
  const Lanes self(job);
  const auto count_up = hn::Iota(numbers, 0);
  found.count = 0;
  for (; cursor.run < job.runs.size(); ++cursor.run, cursor.passed = 0) {
    const BodyRun run = job.runs[cursor.run];
    for (std::uint32_t first = run.first + cursor.passed; first < run.end; first += lanes) {
      if (found.count + lanes > NearBodies::most) {
        cursor.passed = first - run.first;
        return false;
      }
      const auto in_run = hn::FirstN(d, std::min(run.end - first, lanes));
      const auto mask = hn::RebindMask(numbers, hn::And(in_run, matter(*job.columns, first, self)));
      const auto places = hn::Add(count_up, hn::Set(numbers, first));
      // Some processors compress to memory by the lane, so this compresses in a register. The room holds a vector.
      hn::StoreU(hn::Compress(places, mask), numbers, &found.places[found.count]);
      found.count += hn::CountTrue(numbers, mask);
    }
  }
  return true;
}

}  // namespace throng::app::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::app {

HWY_EXPORT(find);

void BodyColumns::set_aside(std::size_t bodies) {
  for (std::vector<float>* column : {&x, &z, &velocity_x, &velocity_z, &radius, &share_of_gap}) {
    column->assign(bodies + most_lanes, 0.0F);
  }
  company.assign(bodies + most_lanes, 0);
}

bool is_valid(const NearBodiesJob& job) {
  if (job.columns == nullptr || job.columns->x.size() < BodyColumns::most_lanes) return false;
  const std::size_t bodies = job.columns->x.size() - BodyColumns::most_lanes;
  return std::ranges::all_of(job.runs, [&](const BodyRun& run) { return run.first <= run.end && run.end <= bodies; });
}

bool find_near_bodies(const NearBodiesJob& job, NearBodiesCursor& cursor, NearBodies& found) {
  assert(is_valid(job));
  return HWY_DYNAMIC_DISPATCH(find)(job, cursor, found);
}

}  // namespace throng::app
#endif  // HWY_ONCE
