#include "engine/anim/kernel/pose/offset.h"

namespace throng::anim {
namespace {

/// The root of (1 + u) e^-u = 1/2.
constexpr double decay_at_half_life = 1.6783469900166605;

/// e^-u for u of 0 to 16, to 1e-8 of it: a series of u / 128, squared seven times. Only additions and multiplications,
/// which every machine rounds in the same way.
double decayed(double u) {
  const double part = u / 128.0;
  double value = 1.0;
  for (int term = 6; term >= 1; --term) value = 1.0 - value * part / term;
  for (int doubling = 0; doubling < 7; ++doubling) value *= value;
  return value;
}

}  // namespace

OffsetDecay offset_decay(float seconds, float half_life) {
  if (!(half_life > 0.0F) || seconds >= offset_half_lives * half_life) return {};
  const double t = seconds > 0.0F ? static_cast<double>(seconds) : 0.0;
  const double u = decay_at_half_life * t / static_cast<double>(half_life);
  const double left = decayed(u);
  return {static_cast<float>((1.0 + u) * left), static_cast<float>(t * left)};
}

}  // namespace throng::anim
