#include "app/show/stage/gazes.h"

namespace throng::app {
namespace {

constexpr Ticks fade_away = ticks_per_second / 5;

// The target moves as slowly as a head turns, so nothing smooths it, and the head depends on no frame before.
anim::LookAtProcess new_gaze(anim::EntityPools::Kind kind) {
  return anim::LookAtProcess(kind, {.smooth_seconds = 0.0F});
}

}  // namespace

void Gazes::look(std::uint32_t agent, const glm::vec3& target, float share) {
  if (lend(agent, new_gaze) == Lent::no) return;
  change(agent, [&](anim::LookAtProcess& gaze) {
    gaze.set_target(target);
    gaze.set_weight(share);
  });
}

void Gazes::look_away(std::uint32_t agent) { let_go(agent, fade_away); }

}  // namespace throng::app
