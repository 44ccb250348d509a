#include "app/people/crowd/followers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/base/random.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr std::uint64_t headings_stream = 17;

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

// The file says how tall some people are. The others have the sizes that the seed gave them.
void take_statures(const Trajectories& all, const CrowdCast& cast, std::span<float> scales) {
  for (std::size_t agent = 0; agent < scales.size(); ++agent) {
    const float stature = all.persons[agent].stature;
    if (stature > 0.0F) scales[agent] = stature / static_cast<float>(cast.of(agent).height);
  }
}

}  // namespace

Followers::Followers(TrackSource source, std::span<const std::uint8_t> characters, std::span<const float> scales,
                     std::uint32_t seed)
    : source_(std::move(source)),
      characters_(characters.begin(), characters.end()),
      scales_(scales.begin(), scales.end()),
      bounds_(bounds_of(*source_.trajectories)) {
  const Trajectories& all = *source_.trajectories;
  assert(all.persons.size() == characters.size() && characters.size() == scales.size());
  const double row = row_seconds(all);
  Random random(seed, headings_stream);
  constexpr float half_turn = std::numbers::pi_v<float>;
  for (std::size_t agent = 0; agent < characters.size(); ++agent) {
    const PersonTrack& person = all.persons[agent];
    first_headings_.push_back(random.between(-half_turn, half_turn));
    presences_.push_back(presence_of(person, row));
    tracks_.push_back(person.rows.empty() ? SmoothTrack() : SmoothTrack(person.rows));
    steps_.emplace_back(tracks_.back(), plane(agent), scales[agent], first_headings_.back());
  }
  talks_ = Talks(tracks_, steps_);
}

void Followers::begin_renewing(std::span<const std::uint32_t> agents) {
  talks_ = {};
  for (const std::uint32_t agent : agents) add_to(bounds_, source_.trajectories->persons[agent].rows.back());
}

float Followers::renew(std::size_t agent, float height, double settled) {
  const PersonTrack& person = source_.trajectories->persons[agent];
  const float scale = person.stature > 0.0F ? person.stature / height : scales_[agent];
  Presence& known = presences_[agent];
  Presence now = presence_of(person, row_seconds(*source_.trajectories));
  if (now.first <= known.last) now.first = std::min(now.first, known.first);  // older rows may be gone
  known = now;
  tracks_[agent] = SmoothTrack(person.rows);
  steps_[agent].extend(tracks_[agent], plane(agent), scale, first_headings_[agent], settled);
  return scale;
}

FollowedTracks::FollowedTracks(const TrackSource& source, const CrowdCast& cast, std::span<float> scales,
                               std::uint32_t seed)
    : absent_(scales.size()) {
  const Trajectories& all = *source.trajectories;
  take_statures(all, cast, scales);
  people_ = std::make_shared<Followers>(source, cast.numbers(), scales, seed);
  clock_ = {.seconds = all.first_seconds, .first = all.first_seconds, .last = all.last_seconds};
}

void FollowedTracks::place(const CrowdCast& cast, std::span<const float> scales, CrowdPlaces& places, CrowdMinds& minds,
                           Executor& executor, int jobs) {
  visit_in_tiles(people_->count(), executor, jobs, [&](std::size_t agent) {
    absent_[agent] = people_->is_there(agent, clock_.seconds) ? 0 : 1;
    if (absent_[agent] != 0) return;
    const TrackStep step = people_->step(agent, clock_.seconds);
    places.positions[agent] = people_->position(agent, clock_.seconds);
    places.headings[agent] = {std::cos(step.heading), std::sin(step.heading)};
    places.speeds[agent] = glm::length(step.velocity) * scales[agent];
    minds.note_role(agent, gait_at(cast.of(agent), glm::length(step.velocity)));
  });
}

void FollowedTracks::take(const LiveStep& step, const CrowdCast& cast, std::span<float> scales, Executor& executor,
                          int jobs) {
  clock_ = step.clock;
  people_->begin_renewing(step.changed);
  visit_in_tiles(step.changed.size(), executor, jobs, [&](std::size_t i) {
    const std::uint32_t agent = step.changed[i];
    scales[agent] = people_->renew(agent, static_cast<float>(cast.of(agent).height), step.settled);
  });
}

}  // namespace throng::app
