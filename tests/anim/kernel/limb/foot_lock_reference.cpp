#include "tests/anim/kernel/limb/foot_lock_reference.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {

namespace {

constexpr float planted_from = 0.5F;
constexpr glm::vec3 up{0.0F, 1.0F, 0.0F};

float horizontal_distance(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::vec2(a.x - b.x, a.z - b.z));
}

/// 1 when let go, 0 after release_seconds, without a kink at either end.
float fading(float released_for, float release_seconds) {
  const float t = release_seconds > 0.0F ? std::min(released_for / release_seconds, 1.0F) : 1.0F;
  return 1.0F - t * t * (3.0F - 2.0F * t);
}

Footing free_footing(const FootLock& lock, const Footing& posed, const FootLockOptions& options) {
  const float fade = fading(lock.released_for, options.release_seconds);
  if (fade <= 0.0F) return posed;
  const glm::vec3 offset = lock.offset * fade;
  const float x = posed.place.x + offset.x;
  const float z = posed.place.z + offset.z;
  return {.place = {x, ground_height(posed, x, z) + offset.y, z},
          .normal = unit_or(posed.normal * (1.0F - fade) + lock.normal * fade, up)};
}

/// The foot goes from its lock, or from where its leg left it short of that.
void let_go(FootLock& lock, const Footing& posed, bool is_short) {
  glm::vec3 from = lock.place;
  if (is_short) {
    from = lock.last_ball;
    from.y = ground_height({.place = lock.place, .normal = lock.normal}, from.x, from.z);
  }
  lock.flags &= ~FootLock::is_locked;
  lock.released_for = 0.0F;
  lock.offset = from - posed.place;
  lock.offset.y = from.y - ground_height(posed, from.x, from.z);
}

void set(FootLock& lock, std::uint32_t flag, bool on) { lock.flags = on ? lock.flags | flag : lock.flags & ~flag; }
bool has(const FootLock& lock, std::uint32_t flag) { return (lock.flags & flag) != 0; }

void bring_back(FootLock& lock, const FootLockOptions& options, float seconds, float reached) {
  lock.released_for += seconds;
  if (seconds > 0.0F) {
    lock.offset.x *= reached;
    lock.offset.z *= reached;
  }
  if (lock.released_for < options.release_seconds) return;
  lock.offset = glm::vec3(0.0F);
  set(lock, FootLock::is_stepping, false);
}

}  // namespace

Footing step_foot_lock(FootLock& lock, const Footing& posed, float planted, const FootLockOptions& options,
                       float seconds, float reached) {
  assert(seconds >= 0.0F);
  const bool is_planted = planted >= planted_from && options.enabled;
  if (!is_planted) {
    set(lock, FootLock::is_overstretched, false);
    set(lock, FootLock::is_stepping, false);
  }
  const bool is_short = reached < 1.0F;
  const bool gives_way = is_short && seconds > 0.0F;
  const bool too_far = horizontal_distance(lock.place, posed.place) > options.farthest;
  if (lock.locked() && (!is_planted || too_far || gives_way)) {
    let_go(lock, posed, is_short);
    set(lock, FootLock::is_overstretched, too_far && is_planted);
    set(lock, FootLock::is_stepping, gives_way && is_planted);
  } else if (!lock.locked()) {
    bring_back(lock, options, seconds, reached);
  }
  if (!lock.locked() && is_planted && !has(lock, FootLock::is_overstretched) && !has(lock, FootLock::is_stepping)) {
    const Footing here = free_footing(lock, posed, options);
    set(lock, FootLock::is_locked, true);
    lock.place = here.place;
    lock.normal = here.normal;
  }
  if (lock.locked()) return {.place = lock.place, .normal = lock.normal};
  return free_footing(lock, posed, options);
}

float rise_of_step(const FootLock& lock, float planted, const FootLockOptions& options, float least) {
  if (lock.locked() || !(has(lock, FootLock::is_overstretched) || has(lock, FootLock::is_stepping))) return 0.0F;
  const float fade = fading(lock.released_for, options.release_seconds);
  const float distance = glm::length(glm::vec2(lock.offset.x, lock.offset.z));
  const float highest = std::max(step_height * distance, least);
  return 4.0F * highest * std::max(2.0F * planted - 1.0F, 0.0F) * fade * (1.0F - fade);
}

void measure_slide(FootLock& lock, const glm::vec3& ball, float planted, float seconds) {
  const bool is_planted = planted >= planted_from;
  if (is_planted && (lock.flags & FootLock::is_standing) != 0) {
    lock.slid += horizontal_distance(ball, lock.last_ball);
    lock.standing_seconds += seconds;
  } else if (is_planted) {
    lock.slid = 0.0F;
    lock.standing_seconds = 0.0F;
  }
  set(lock, FootLock::is_standing, is_planted);
  lock.last_ball = ball;
}

}  // namespace throng::anim
