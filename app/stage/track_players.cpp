#include "app/stage/track_players.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "app/character/gait_plane.h"

namespace throng::app {
namespace {

FollowedMix mix_at(const Crowd& crowd, const CharacterSource& source, const Stances& stances, std::uint32_t agent,
                   anim::Ticks ahead) {
  const Followers& followers = *followers_of(crowd);
  TrackClock clock = track_clock_of(crowd);
  advance(clock, anim::to_seconds(ahead));
  const FollowedMoment moment{.step = followers.step(agent, clock.seconds),
                              .seconds = clock.seconds,
                              .rate = clock.rate,
                              .ahead = ahead,
                              .person = agent};
  return followed_mix(moment, followers.plane(agent), stances, source.roles, *source.character);
}

}  // namespace

StridePlane stride_plane_of(const CharacterSource& source) {
  const auto seconds_of = [&](int clip) {
    return anim::to_seconds(source.character->clips[static_cast<std::size_t>(clip)].duration);
  };
  std::vector<StridePoint> points;
  for (const GaitPoint& gait : gait_points(source.roles)) {
    points.push_back({.clip = gait.clip, .velocity = gait.velocity, .seconds = seconds_of(gait.clip)});
  }
  const int steps = source.roles.clip(Role::step_in_place);
  if (steps == no_clip || points.size() < 2) return {std::move(points), StridePlane::Middle::stands};
  points.front() = {.clip = steps, .velocity = glm::vec2(0.0F), .seconds = seconds_of(steps)};
  return {std::move(points), StridePlane::Middle::steps};
}

TrackSource track_source(std::shared_ptr<const Trajectories> trajectories,
                         std::span<const CharacterSource> characters) {
  TrackSource source{.trajectories = std::move(trajectories), .planes = {}};
  if (source.trajectories == nullptr) return source;
  for (const CharacterSource& character : characters) source.planes.push_back(stride_plane_of(character));
  return source;
}

TrackPlayers::TrackPlayers(anim::AnimationSystem& system, const Crowd& crowd,
                           std::span<const CharacterSource> characters)
    : system_(&system), crowd_(&crowd), characters_(characters) {
  for (const CharacterSource& each : characters) stances_.emplace_back(*each.character, stride_plane_of(each));
  for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
    const FollowedMix mix = mix_of(agent, {});
    [[maybe_unused]] const auto added =
        system.agent(agent).add_channel(std::make_unique<anim::ClipMixChannel>(mix.clips()));
    assert(added && "clips of roles are those of the character");
  }
}

FollowedMix TrackPlayers::mix_of(std::uint32_t agent, anim::Ticks ahead) const {
  const std::size_t character = crowd_->characters()[agent];
  return mix_at(*crowd_, characters_[character], stances_[character], agent, ahead);
}

std::array<float, person_legs> TrackPlayers::planted(std::uint32_t agent) const { return mix_of(agent, {}).planted; }

void TrackPlayers::set(std::span<const anim::AgentUpdate> updates) {
  for (const anim::AgentUpdate& update : updates) set(update.agent.number, update.look_ahead);
}

void TrackPlayers::set(std::uint32_t agent, anim::Ticks ahead) {
  const FollowedMix mix = mix_of(agent, ahead);
  const anim::AgentView posed = std::as_const(*system_).agent(agent);
  [[maybe_unused]] const anim::Status changed = system_->agent(agent).change<anim::ClipMixChannel>(
      posed.channel_id(0), [&](anim::ClipMixChannel& channel) { channel.set(mix.clips()); });
  assert(changed && "a mix of four clips has room in every local store that plays them");
}

}  // namespace throng::app
