#include "engine/anim/asset/user_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace throng::anim {

UserCurve bake_curve(const NamedCurve& curve, double start, std::uint32_t name) {
  UserCurve baked{.name = name, .times = {}, .values = curve.values};
  for (const float time : curve.times) baked.times.push_back(to_ticks(static_cast<double>(time) - start));
  return baked;
}

const UserCurve* find_curve(const UserCurves& curves, std::uint32_t name) {
  const auto found = std::ranges::find(curves, name, &UserCurve::name);
  return found == curves.end() ? nullptr : &*found;
}

float value_at(const UserCurve& curve, Ticks time) {
  const auto after = std::ranges::upper_bound(curve.times, time);
  if (after == curve.times.begin()) return curve.values.front();
  if (after == curve.times.end()) return curve.values.back();
  const auto next = static_cast<std::size_t>(after - curve.times.begin());
  const auto passed = static_cast<double>((time - curve.times[next - 1]).count());
  const auto length = static_cast<double>((curve.times[next] - curve.times[next - 1]).count());
  return std::lerp(curve.values[next - 1], curve.values[next], static_cast<float>(passed / length));
}

}  // namespace throng::anim
