#include "engine/anim/lod/bone_step.h"

namespace throng::anim {
namespace {

constexpr std::uint8_t there = 2;

BoneStep faded(const BoneStep& now, int halves) {
  return {.level = now.level, .fade_level = now.fade_level, .fade_halves = static_cast<std::uint8_t>(halves)};
}

}  // namespace

BoneStep next_step(const BoneStep& now, std::uint8_t wanted) {
  if (now.fade_halves == 0) {
    if (wanted == now.level) return settled_at(wanted);
    if (wanted > now.level) return {.level = now.level, .fade_level = wanted, .fade_halves = 1};
    return {.level = wanted, .fade_level = now.level, .fade_halves = there};
  }
  if (wanted <= now.level) return now.fade_halves == 1 ? settled_at(now.level) : faded(now, now.fade_halves - 1);
  if (now.fade_halves < there) return faded(now, now.fade_halves + 1);
  return settled_at(now.fade_level);
}

}  // namespace throng::anim
