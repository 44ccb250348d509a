#include "app/stage/track_players.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <glm/geometric.hpp>

#include "app/stage/followed_mix.h"

namespace throng::app {
namespace {

constexpr float least_apart = 0.1F;  // metres a second between two gaits

FollowedMix mix_at(const Crowd& crowd, const CharacterSource& source, std::uint32_t agent, anim::Ticks ahead) {
  const Followers& followers = *followers_of(crowd);
  TrackClock clock = track_clock_of(crowd);
  advance(clock, anim::to_seconds(ahead));
  const FollowedMoment moment{.step = followers.step(agent, clock.seconds),
                              .seconds = clock.seconds,
                              .rate = clock.rate,
                              .ahead = ahead,
                              .person = agent};
  return followed_mix(moment, followers.plane(agent), source.roles, *source.character);
}

}  // namespace

StridePlane stride_plane_of(const CharacterSource& source) {
  const CharacterRoles& roles = source.roles;
  const int stand = roles.clip(Role::stand);
  const int other = roles.others.empty() ? 0 : roles.others.front();
  std::vector<StridePoint> points{{.clip = stand == no_clip ? other : stand}};
  for (const Role gait : {Role::walk, Role::jog, Role::run}) {
    const auto speed = static_cast<float>(roles.ground_speed(gait));
    if (roles.clip(gait) == no_clip || speed <= 0.0F) continue;
    const glm::vec2 velocity(0.0F, speed);
    const auto is_near = [&](const StridePoint& point) {
      return glm::distance(point.velocity, velocity) < least_apart;
    };
    if (std::ranges::any_of(points, is_near)) continue;
    const anim::BakedClip& clip = source.character->clips[static_cast<std::size_t>(roles.clip(gait))];
    points.push_back({.clip = roles.clip(gait), .velocity = velocity, .seconds = anim::to_seconds(clip.duration)});
  }
  return StridePlane(std::move(points));
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
  for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
    const FollowedMix mix = mix_at(crowd, characters_[crowd.characters()[agent]], agent, {});
    [[maybe_unused]] const auto added =
        system.agent(agent).add_channel(std::make_unique<anim::ClipMixChannel>(mix.clips()));
    assert(added && "clips of roles are those of the character");
  }
}

void TrackPlayers::set(std::span<const anim::AgentUpdate> updates) {
  for (const anim::AgentUpdate& update : updates) set(update.agent.number, update.look_ahead);
}

void TrackPlayers::set(std::uint32_t agent, anim::Ticks ahead) {
  const FollowedMix mix = mix_at(*crowd_, characters_[crowd_->characters()[agent]], agent, ahead);
  const anim::AgentView posed = std::as_const(*system_).agent(agent);
  [[maybe_unused]] const anim::Status changed = system_->agent(agent).change<anim::ClipMixChannel>(
      posed.channel_id(0), [&](anim::ClipMixChannel& channel) { channel.set(mix.clips()); });
  assert(changed && "a mix of four clips has room in every local store that plays them");
}

}  // namespace throng::app
