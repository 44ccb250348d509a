// These members of AnimatedCrowd hold a clip, push an agent over and take time back, as a person asks.
#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

#include "app/show/stage/animated_crowd.h"
#include "app/show/stage/moment.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr double fade_after_holding = 0.3;  // seconds
constexpr float push_impulse = 60.0F;       // kg m/s: a hard shove
constexpr double push_height = 0.75;        // of the character's, where it is met

}  // namespace

float AnimatedCrowd::clip_seconds(std::uint32_t agent) const {
  const int clip = holds_clip(agent) ? held_clip_->clip : crowd_->minds().clips()[agent];
  if (clip == no_clip) return 0;
  const anim::Character& character = *character_of(agent).character;
  return static_cast<float>(to_seconds(character.clips[static_cast<std::size_t>(clip)].duration));
}

void AnimatedCrowd::hold_clip(std::uint32_t agent, float seconds) {
  if (follows_a_script(agent) || fallen_->phase(agent) != FallenAgents::Phase::standing) return;
  if (!holds_clip(agent)) {
    let_go_of_clip();
    held_clip_ = {.agent = agent, .clip = crowd_->minds().clips()[agent]};
    crowd_->hold(agent);
  }
  if (held_clip_->clip == no_clip) return;
  held_clip_->seconds = std::clamp(seconds, 0.0F, clip_seconds(agent));
  system_->agent(agent).play({.clip = held_clip_->clip,
                              .fade = {},
                              .speed = 0.0,
                              .start = to_ticks(static_cast<double>(held_clip_->seconds))});
  lod_->make_due(agent);
}

void AnimatedCrowd::let_go_of_clip() {
  if (!held_clip_) return;
  const std::uint32_t agent = held_clip_->agent;
  held_clip_.reset();
  crowd_->release(agent);
  change_clip(agent, crowd_->minds().clips()[agent], to_ticks(fade_after_holding));
}

bool AnimatedCrowd::can_fall(std::uint32_t agent) const { return fallen_->possible(agent) && !follows_a_script(agent); }

Status AnimatedCrowd::push_over(std::uint32_t agent, const glm::vec3& direction) {
  const CharacterSource& character = character_of(agent);
  if (follows_a_script(agent)) {
    return Error{"an agent that acts in the cut scene or follows a file cannot be pushed over"};
  }
  if (!can_fall(agent)) {
    const std::string missing = joined(rigs_[crowd_->characters()[agent]]->missing(), "; ", "; ");
    return Error{character.name + " cannot be pushed over: " + missing};
  }
  if (holds_clip(agent)) let_go_of_clip();
  const Heading heading = crowd_->headings()[agent];
  const glm::vec2 way(heading.cosine * direction.x - heading.sine * direction.z,
                      heading.sine * direction.x + heading.cosine * direction.z);
  const glm::vec2 impulse = way * (push_impulse / std::max(glm::length(way), 1e-3F));
  const bool stood = !crowd_->minds().holds(agent);
  if (stood) change_clip(crowd_->hold(agent));
  const auto chest = static_cast<float>(push_height * character.character->bounds.height);
  Status pushed = fallen_->push(agent, {impulse.x, 0.0F, impulse.y}, {0.0F, chest, 0.0F});
  if (!pushed && stood) change_clip(crowd_->release(agent));
  return pushed;
}

void AnimatedCrowd::let_fallen_get_up() {
  for (const std::uint32_t agent : fallen_->advance()) change_clip(crowd_->release(agent));
}

void AnimatedCrowd::remember(StageMoment& into) const {
  into.crowd_number = number_;
  into.clock = system_->clock();
  system_->snapshot(into.system);
  into.crowd = crowd_->state();
  into.cut_scene = cut_scene_ ? std::optional(cut_scene_->moment()) : std::nullopt;
  into.fallen = *fallen_;
  details_->remember(into.details);
  into.played_speeds = played_speeds_;
}

Status AnimatedCrowd::go_back_to(const StageMoment& moment) {
  if (moment.crowd_number != number_) return Error{"that moment is of another crowd"};
  if (Status restored = system_->restore(moment.system); !restored) return restored;
  crowd_->go_back_to(*moment.crowd);
  if (cut_scene_ && moment.cut_scene) cut_scene_->go_back_to(*moment.cut_scene);
  *fallen_ = *moment.fallen;
  details_->go_back_to(moment.details);
  played_speeds_ = moment.played_speeds;
  held_clip_.reset();
  return Done{};
}

}  // namespace throng::app
