// These members of Crowd follow the tracks of a recorded crowd.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/crowd/crowd.h"
#include "app/crowd/steering/tiles.h"

namespace throng::app {
namespace {

/// Returns the gait that a speed, in metres a second at scale 1, is nearest to.
Role gait_at(const CharacterRoles& character, float speed) {
  constexpr double stands = 0.3;  // of the walk
  const auto metres = static_cast<double>(speed);
  if (metres < stands * character.walk_speed) return Role::stand;
  if (character.run_speed > 0.0 &&
      metres * metres > character.run_speed * std::max(character.jog_speed, character.walk_speed)) {
    return Role::run;
  }
  return character.jog_speed > 0.0 && metres * metres > character.jog_speed * character.walk_speed ? Role::jog
                                                                                                   : Role::walk;
}

}  // namespace

// The file says how tall some people are. The other people have the sizes that the seed gave them.
void Crowd::follow(const TrackSource& tracks, std::uint32_t seed) {
  const Trajectories& all = *tracks.trajectories;
  for (std::size_t agent = 0; agent < size(); ++agent) {
    const float stature = all.persons[agent].stature;
    if (stature > 0.0F) looks_.scales[agent] = stature / static_cast<float>(cast_.of(agent).height);
  }
  followers_.emplace(tracks, characters(), scales(), seed);
  state_.absent.assign(size(), 0);
  state_.track_clock = {.seconds = all.first_seconds, .first = all.first_seconds, .last = all.last_seconds};
  anim::InOrder here;
  follow_tracks(here, 1);
}

void Crowd::follow_track(std::size_t agent) {
  const double seconds = state_.track_clock.seconds;
  state_.absent[agent] = followers_->is_there(agent, seconds) ? 0 : 1;
  if (state_.absent[agent] != 0) return;
  const TrackStep step = followers_->step(agent, seconds);
  state_.positions[agent] = followers_->position(agent, seconds);
  state_.headings[agent] = {std::cos(step.heading), std::sin(step.heading)};
  state_.speeds[agent] = glm::length(step.velocity) * scales()[agent];
  state_.minds.tell(agent, gait_at(cast_.of(agent), glm::length(step.velocity)));
}

void Crowd::follow_tracks(anim::Executor& executor, int jobs) {
  visit_in_tiles(followers_->count(), executor, jobs, [this](std::size_t agent) { follow_track(agent); });
}

void set_track_clock(Crowd& crowd, const TrackClock& clock) {
  crowd.state_.track_clock = clock;
  anim::InOrder here;
  crowd.follow_tracks(here, 1);
}

void take_live_step(Crowd& crowd, const LiveStep& step, anim::Executor& executor, int jobs) {
  crowd.state_.track_clock = step.clock;
  crowd.followers_->begin_renewing(step.changed);
  visit_in_tiles(step.changed.size(), executor, jobs, [&](std::size_t i) {
    const std::uint32_t agent = step.changed[i];
    const auto height = static_cast<float>(crowd.cast_.of(agent).height);
    crowd.looks_.scales[agent] = crowd.followers_->renew(agent, height, step.settled);
  });
}

}  // namespace throng::app
