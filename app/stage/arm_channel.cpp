#include "app/stage/arm_channel.h"

#include <utility>

#include "engine/anim/entity/inertialiser.h"

namespace throng::app {
namespace {

/// Returns the player of the clip that was asked for last; an invalid handle if that is not known.
anim::Handle newest_player(const anim::EntityBuilder& build, anim::Handle below) {
  while (below.valid()) {
    switch (build.pools().state(below).type) {
      case anim::EntityType::sampled_player:
      case anim::EntityType::keyframe_player:
        return below;
      case anim::EntityType::ease_blender:
        below = build.as<anim::EaseBlender>(below).to;
        break;
      case anim::EntityType::inertialiser:
        below = build.as<anim::Inertialiser>(below).target;
        break;
      default:
        return {};
    }
  }
  return {};
}

constexpr double whole_speed = 65536.0;

}  // namespace

const char* ArmChannel::fault(const anim::EntityBuilder& build) const {
  return build.fault_of({.clip = clip_.clip, .speed = clip_.speed});
}

bool ArmChannel::update(const anim::EntityBuilder& build) {
  const bool had = player_.valid();
  if (is_on_ && !had) player_ = build.player({.clip = clip_.clip, .speed = keeps_step() ? 0.0 : clip_.speed});
  if (!is_on_ && had) destroy_entities(build);
  if (player_.valid() && keeps_step()) keep_step(build);
  return player_.valid() != had;
}

void ArmChannel::keep_step(const anim::EntityBuilder& build) const {
  // The channel below may have changed its graph in this update. Then lie_over() names the new one in the next.
  if (!below_.valid() || !build.pools().alive(below_)) return;
  const anim::Handle gait = newest_player(build, below_);
  const bool steps = gait.valid() && static_cast<int>(build.as<anim::Player>(gait).clip) == clip_.step_clip;
  if (steps) {
    build.set_speed(player_, static_cast<double>(build.as<anim::Player>(gait).speed) / whole_speed);
    build.seek(player_, build.position(gait));
    return;
  }
  const auto& own = build.as<anim::Player>(player_);
  if (own.speed == 0) return;
  // The beginning lies within a sixteenth of the clip behind: it has just been passed.
  const anim::FineTicks whole = build.clip(clip_.clip).duration * anim::fine_ticks_per_tick;
  const anim::FineTicks place = ((build.position(player_) % whole) + whole) % whole;
  if (place > whole / 16) return;
  build.set_speed(player_, 0.0);
  build.seek(player_, 0);
}

void ArmChannel::visit_handles(const std::function<void(anim::Handle&)>& visit) {
  if (player_.valid()) visit(player_);
}

void ArmChannel::destroy_entities(const anim::EntityBuilder& build) {
  if (player_.valid()) build.destroy(std::exchange(player_, {}));
}

}  // namespace throng::app
