#include "app/show/stage/arm_channel.h"

#include <cstddef>
#include <numeric>
#include <utility>

#include "engine/anim/entity/inertialiser.h"
#include "engine/anim/entity/mixer.h"

namespace throng::app {
namespace {

constexpr float least_share = 0.25F;  // of a gait in a mix, with which a step is seen

anim::Handle player_in(const anim::EntityBuilder& build, anim::Handle below, int clip);

anim::Handle player_in_mix(const anim::EntityBuilder& build, anim::Handle mixer, int clip) {
  const auto& mixed = build.private_as<anim::MixerSources>(mixer);
  const std::size_t count = build.as<anim::Mixer>(mixer).source_count;
  const float sum = std::accumulate(mixed.weights, mixed.weights + count, 0.0F);
  for (std::size_t i = 0; i < count; ++i) {
    if (mixed.weights[i] < least_share * sum) continue;
    if (const anim::Handle found = player_in(build, mixed.sources[i], clip); found.valid()) return found;
  }
  return {};
}

/// Returns the player of a clip, if it was asked for last or is mixed in; an invalid handle if not. Recorded crowds
/// mix.
anim::Handle player_in(const anim::EntityBuilder& build, anim::Handle below, int clip) {
  switch (build.pools().state(below).type) {
    case anim::EntityType::sampled_player:
    case anim::EntityType::keyframe_player:
      return static_cast<int>(build.as<anim::Player>(below).clip) == clip ? below : anim::Handle{};
    case anim::EntityType::ease_blender: {
      const auto& blender = build.as<anim::EaseBlender>(below);
      const anim::Handle found = player_in(build, blender.to, clip);
      const bool is_mix = (blender.flags & anim::EaseBlender::held) != 0 && blender.fraction <= 1.0F - least_share;
      return found.valid() || !is_mix ? found : player_in(build, blender.from, clip);
    }
    case anim::EntityType::mixer:
      return player_in_mix(build, below, clip);
    case anim::EntityType::inertialiser:
      return player_in(build, build.as<anim::Inertialiser>(below).target, clip);
    default:
      return {};
  }
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
  auto& own = build.as<anim::Player>(player_);
  if (const anim::Handle gait = player_in(build, below_, clip_.step_clip); gait.valid()) {
    const auto& walking = build.as<anim::Player>(gait);
    build.set_speed(own, static_cast<double>(walking.speed) / whole_speed);
    build.seek(own, build.position(walking));
    return;
  }
  if (own.speed == 0) return;
  // The beginning lies within a sixteenth of the clip behind: it has just been passed.
  const anim::FineTicks whole = build.clip(clip_.clip).duration * anim::fine_ticks_per_tick;
  const anim::FineTicks place = ((build.position(own) % whole) + whole) % whole;
  if (place > whole / 16) return;
  build.set_speed(own, 0.0);
  build.seek(own, 0);
}

void ArmChannel::visit_handles(const std::function<void(anim::Handle&)>& visit) {
  if (player_.valid()) visit(player_);
}

void ArmChannel::destroy_entities(const anim::EntityBuilder& build) {
  if (player_.valid()) build.destroy(std::exchange(player_, {}));
}

}  // namespace throng::app
