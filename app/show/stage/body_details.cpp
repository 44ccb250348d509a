#include "app/show/stage/body_details.h"

#include <utility>
#include <vector>

namespace throng::app {
namespace {

using Kind = std::optional<anim::EntityPools::Kind>;

std::vector<Kind> kinds_of(std::span<const anim::RigKinds> all, Kind anim::RigKinds::*part) {
  std::vector<Kind> kinds;
  for (const anim::RigKinds& each : all) kinds.push_back(each.*part);
  return kinds;
}

}  // namespace

BodyDetails::BodyDetails(std::span<const CharacterSource> characters,
                         std::span<const std::unique_ptr<anim::CharacterRigs>> rigs,
                         std::span<const anim::RigKinds> kinds, anim::AnimationSystem& system)
    : characters_(characters),
      system_(&system),
      feet_(kinds_of(kinds, &anim::RigKinds::foot_placement), system),
      gazes_(kinds_of(kinds, &anim::RigKinds::look_at), system),
      held_arms_(characters, system),
      joined_hands_(characters, rigs, kinds_of(kinds, &anim::RigKinds::limbs), system) {}

void BodyDetails::reset(const Crowd& crowd) {
  crowd_ = &crowd;
  track_players_.reset();
  find_things();
  feet_.reset(crowd.size());
  gazes_.reset(crowd.tracks() != nullptr ? crowd.size() : 0);
  near_.set_aside(crowd.size());
}

void BodyDetails::follow_tracks() { track_players_.emplace(*system_, *crowd_, characters_); }

void BodyDetails::find_things() {
  held_arms_.reset(*crowd_);
  joined_hands_.reset(*crowd_);
}

void BodyDetails::follow_track(std::span<const PoseRequest> updates) {
  if (!track_players_) return;
  if (updates.size() > 1) std::as_const(*system_).agent(updates[1].agent.number).prefetch();
  track_players_->set(updates[0].agent.number, updates[0].look_ahead);
}

void BodyDetails::place_feet(std::uint32_t agent, bool stand, bool is_shown) {
  if (stand && track_players_) {
    feet_.place(*crowd_, agent, is_shown, track_players_->planted(agent));
    turn_head(agent);
  } else if (stand) {
    feet_.place(*crowd_, agent, is_shown);
  } else {
    feet_.let_go(agent);
    if (track_players_) gazes_.look_away(agent);
  }
}

void BodyDetails::turn_head(std::uint32_t agent) {
  if (const auto gaze = track_players_->gaze(agent)) {
    gazes_.look(agent, gaze->target, gaze->share);
  } else {
    gazes_.look_away(agent);
  }
}

void BodyDetails::take_back(std::span<const anim::VisibleAgent> visible) {
  joined_hands_.take_back(visible);  // the last to be lent
  gazes_.take_back(visible);         // a gaze comes after the feet
  feet_.take_back(visible);
}

void BodyDetails::hold_things(std::span<const anim::VisibleAgent> visible) {
  if (held_arms_.empty()) return;
  static_assert(JoinedHands::pixels_to_go_on >= HeldArms::pixels_to_go_on);
  const auto is_near = [visible](std::size_t i, anim::VisibleAgent& listed) {
    listed = visible[i];
    return visible[i].pixels_tall >= HeldArms::pixels_to_go_on;
  };
  const auto near = near_.gather(visible.size(), system_->executor(), system_->options().pus, is_near);
  joined_hands_.find(*crowd_, near);
  held_arms_.show(*crowd_, near, joined_hands_.away());
  joined_hands_.join(held_arms_);
}

void BodyDetails::remember(Moment& into) const {
  into.feet = feet_.moment();
  into.gazes = gazes_.moment();
  into.joined_hands = joined_hands_.moment();
}

void BodyDetails::go_back_to(const Moment& moment) {
  feet_.go_back_to(moment.feet);
  gazes_.go_back_to(moment.gazes);
  joined_hands_.go_back_to(moment.joined_hands);
  held_arms_.find_shown();
}

}  // namespace throng::app
