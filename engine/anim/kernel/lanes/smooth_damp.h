#pragma once

namespace throng::anim {

/// A value that follows another without overshooting it.
struct DampedValue {
  float value = 0.0F;
  float velocity = 0.0F;  ///< per second
};

/// Makes one step of a critically damped spring, stable for any step (T. Lowe, "Critically Damped Ease-In/Ease-Out
/// Smoothing", Game Programming Gems 4). The value is within 10 % of a new target after about twice `smooth_seconds`;
/// it is there at once if these are 0. `seconds` is not negative; the value keeps its bits if it is 0.
inline DampedValue smooth_damp(const DampedValue& from, float target, float smooth_seconds, float seconds) {
  if (smooth_seconds <= 0.0F) return {target, 0.0F};
  const float stiffness = 2.0F / smooth_seconds;
  const float x = stiffness * seconds;
  const float decay = 1.0F / (1.0F + x + 0.48F * x * x + 0.235F * x * x * x);
  const float distance = from.value - target;
  const float pull = (from.velocity + stiffness * distance) * seconds;
  const float value = seconds > 0.0F ? target + (distance + pull) * decay : from.value;
  DampedValue to{value, (from.velocity - stiffness * pull) * decay};
  const bool overshot = distance > 0.0F ? to.value < target : to.value > target;
  if (overshot && from.value != target) to = {target, 0.0F};
  return to;
}

}  // namespace throng::anim
