#pragma once

#include <cstdint>
#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// A number over the time of a baked clip (NamedCurve). Between keys it is linear; before the first and after the
/// last, the nearest holds.
struct UserCurve {
  std::uint32_t name = 0;    ///< index into Character::curve_names
  std::vector<Ticks> times;  ///< ascending, at least one
  std::vector<float> values;
};
using UserCurves = std::vector<UserCurve>;

/// Makes the curve of a clip whose time 0 is `start` seconds of the file.
UserCurve bake_curve(const NamedCurve& curve, double start, std::uint32_t name);

/// Returns the curve of this name; null if there is none.
const UserCurve* find_curve(const UserCurves& curves, std::uint32_t name);

float value_at(const UserCurve& curve, Ticks time);

}  // namespace throng::anim
