#include "app/show/stage/track_players.h"

#include <array>
#include <cassert>
#include <utility>

#include "app/character/gait_plane.h"

namespace throng::app {

StridePlane stride_plane_of(const CharacterSource& source) {
  std::vector<StridePoint> points;
  for (const GaitPoint& gait : gait_points(source.roles, Middle::steps)) {
    const anim::BakedClip& clip = source.character->clips[static_cast<std::size_t>(gait.clip)];
    points.push_back({.gait = gait, .seconds = to_seconds(clip.duration)});
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
    : system_(&system), crowd_(&crowd), characters_(characters), planted_(crowd.size()) {
  const Followers& followers = crowd.tracks()->people();
  for (std::size_t i = 0; i < characters.size(); ++i) {
    stances_.emplace_back(*characters[i].character, followers.plane_of_character(i));
  }
  for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
    const FollowedMix mix = mix_of(agent, crowd.tracks()->clock().seconds, {});
    [[maybe_unused]] const auto added =
        system.agent(agent).add_channel(std::make_unique<anim::ClipMixChannel>(mix.clips()));
    assert(added && "clips of roles are those of the character");
  }
}

FollowedMix TrackPlayers::mix_of(std::uint32_t agent, double seconds, Ticks ahead) const {
  const Followers& followers = crowd_->tracks()->people();
  const TrackClock& clock = crowd_->tracks()->clock();
  const std::size_t character = crowd_->characters()[agent];
  const CharacterSource& source = characters_[character];
  TrackStep step = followers.step(agent, seconds);
  step.velocity *= 1.0F - clock.stands;
  const FollowedMoment moment{.step = step,
                              .seconds = seconds,
                              .rate = clock.rate,
                              .ahead = ahead,
                              .person = agent,
                              .speaks = followers.talk(agent, seconds).speaks};
  return followed_mix(moment, followers.plane(agent), stances_[character], source.roles, *source.character);
}

std::array<float, person_legs> TrackPlayers::planted_at(std::uint32_t agent, double seconds) const {
  return mix_of(agent, seconds, {}).planted;
}

std::optional<TrackPlayers::Gaze> TrackPlayers::gaze(std::uint32_t agent) const {
  const Followers& followers = crowd_->tracks()->people();
  const double seconds = crowd_->tracks()->clock().seconds;
  const TalkMoment talk = followers.talk(agent, seconds);
  if (talk.looks <= 0.0F) return std::nullopt;
  constexpr float eyes = 0.93F;  // of a person's height
  const auto height = static_cast<float>(characters_[crowd_->characters()[talk.other]].roles.height);
  const glm::vec3 way = followers.position(talk.other, seconds) - crowd_->positions()[agent];
  const Heading heading = crowd_->headings()[agent];
  const glm::vec3 target(way.x * heading.cosine - way.z * heading.sine,
                         way.y + eyes * height * crowd_->scales()[talk.other],
                         way.x * heading.sine + way.z * heading.cosine);
  return Gaze{.target = target / crowd_->scales()[agent], .share = talk.looks};
}

void TrackPlayers::set(std::uint32_t agent, Ticks ahead) {
  TrackClock clock = crowd_->tracks()->clock();
  advance(clock, to_seconds(ahead));
  const FollowedMix mix = mix_of(agent, clock.seconds, ahead);
  planted_[agent] = mix.planted;
  const anim::AgentView posed = std::as_const(*system_).agent(agent);
  [[maybe_unused]] const Status changed = system_->agent(agent).change<anim::ClipMixChannel>(
      posed.channel_id(0), [&](anim::ClipMixChannel& channel) { channel.set(mix.clips()); });
  assert(changed && "a mix of five clips has room in every local store that plays them");
}

}  // namespace throng::app
