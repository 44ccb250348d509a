// What a person does to a stage by hand: hold somebody's clip, and take the crowd back in time.
#include <algorithm>

#include "app/stage/moment.h"
#include "app/stage/stage.h"

namespace throng::app {
namespace {

constexpr double fade_after_holding = 0.3;  // seconds

}  // namespace

void Stage::select(std::optional<std::uint32_t> agent) {
  if (held_clip_ && held_clip_->agent != agent) let_go_of_clip();
  selected_ = agent;
}

float Stage::clip_seconds(std::uint32_t agent) const {
  const int clip = holds_clip(agent) ? held_clip_->clip : crowd_->clips()[agent];
  if (clip == no_clip) return 0;
  const anim::Character& character = *character_of(agent).character;
  return static_cast<float>(anim::to_seconds(character.clips[static_cast<std::size_t>(clip)].duration));
}

void Stage::hold_clip(std::uint32_t agent, float seconds) {
  if (crowd_->habits()[agent] == Habit::act || fallen_->phase(agent) != FallenAgents::Phase::standing) return;
  if (!holds_clip(agent)) {
    if (held_clip_) let_go_of_clip();
    held_clip_ = {.agent = agent, .clip = crowd_->clips()[agent]};
    crowd_->hold(agent);
  }
  if (held_clip_->clip == no_clip) return;
  held_clip_->seconds = std::clamp(seconds, 0.0F, clip_seconds(agent));
  system_->agent(agent).play({.clip = held_clip_->clip,
                              .fade = 0,
                              .speed = 0.0,
                              .start = anim::to_ticks(static_cast<double>(held_clip_->seconds))});
  lod_.make_due(agent);
}

void Stage::let_go_of_clip() {
  if (!held_clip_) return;
  const std::uint32_t agent = held_clip_->agent;
  held_clip_.reset();
  crowd_->release(agent);
  request_clip(agent, crowd_->clips()[agent], anim::to_ticks(fade_after_holding), 0.0);
}

void Stage::remember(StageMoment& into) const {
  into.crowd_number = crowd_number_;
  into.clock = system_->clock();
  system_->snapshot(into.system);
  crowd_->remember(into.crowd);
  into.cut_scene = cut_scene_ ? std::optional(cut_scene_->moment()) : std::nullopt;
  into.fallen = *fallen_;
  into.feet = feet_->moment();
  into.played_speeds = played_speeds_;
}

anim::Status Stage::go_back_to(const StageMoment& moment) {
  if (moment.crowd_number != crowd_number_) return anim::Error{"that moment is of another crowd"};
  if (const anim::Status restored = system_->restore(moment.system); !restored) return restored;
  crowd_->go_back_to(moment.crowd);
  if (cut_scene_ && moment.cut_scene) cut_scene_->go_back_to(*moment.cut_scene);
  *fallen_ = *moment.fallen;
  feet_->go_back_to(moment.feet);
  played_speeds_ = moment.played_speeds;
  held_clip_.reset();
  // What is shown are poses of the future.
  shown_.reset(crowd_->size(), frame_);
  meter_.reset(crowd_->size());
  bone_steps_.assign(crowd_->size(), {});
  lod_.make_all_due();
  crowd_lod_.reset(crowd_->size(), tuning_);
  bone_steps_.assign(crowd_->size(), {});
  meter_.reset(crowd_->size());
  return anim::Done{};
}

}  // namespace throng::app
