#include "app/crowd.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace throng::app {
namespace {

constexpr float shortest = 0.90F, tallest = 1.08F;           // scale
constexpr float slowest = 0.90F, fastest = 1.10F;            // playback
constexpr float shortest_rest = 4.0F, longest_rest = 14.0F;  // seconds
constexpr float shortest_act = 2.5F, longest_act = 6.0F;
constexpr float shortest_fade = 0.3F, longest_fade = 0.8F;
constexpr float share_acting_at_first = 0.3F;

constexpr anim::Ticks never = std::numeric_limits<anim::Ticks>::max();

constexpr std::uint64_t looks_stream = 4;
constexpr std::uint64_t first_whim_stream = 16;

std::vector<StandingClip> standing_clips(const CharacterRoles& character) {
  std::vector<StandingClip> clips;
  if (character.clip(Role::idle) == no_clip) {
    for (const int clip : character.others) clips.push_back({Role::other, clip});
    return clips;
  }
  for (const Role role : {Role::idle, Role::cheer, Role::wave, Role::clap}) {
    if (character.clip(role) != no_clip) clips.push_back({role, character.clip(role)});
  }
  return clips;
}

anim::Ticks some_time(Random& whim, float least, float most) {
  return anim::to_ticks(static_cast<double>(whim.between(least, most)));
}

}  // namespace

Crowd::Crowd(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles)
    : character_(roles), standing_clips_(standing_clips(roles)) {
  CrowdLayout layout = scene == Scene::plaza ? plaza_layout(agents, seed, roles) : grid_layout(agents, roles);
  assert(layout.walkers.size() + layout.standers.size() == agents);
  lanes_ = std::move(layout.lanes);
  walkers_ = std::move(layout.walkers);
  positions_.resize(agents);
  headings_.resize(agents);
  for (std::size_t stander = 0; stander < layout.standers.size(); ++stander) {
    const StanderPlace& place = layout.standers[stander];
    positions_[walkers_.size() + stander] = {place.position.x, 0.0, place.position.y};
    headings_[walkers_.size() + stander] = place.heading;
  }
  move_walkers();
  give_looks(seed);
  give_first_clips(seed);
  requests_.reserve(agents);
}

void Crowd::give_looks(std::uint32_t seed) {
  Random random(seed, looks_stream);
  for (std::size_t agent = 0; agent < size(); ++agent) {
    // The product of the two is the pace, and all of a lane keep one pace.
    const bool walks = agent < walkers_.size();
    const double pace = walks ? lanes_[walkers_[agent].lane].speed / character_.walk_speed : 1.0;
    const float least = walks ? std::max(shortest, static_cast<float>(pace) / fastest) : shortest;
    const float most = walks ? std::min(tallest, static_cast<float>(pace) / slowest) : tallest;
    const float scale = random.between(least, most);
    scales_.push_back(scale);
    playback_speeds_.push_back(walks ? static_cast<float>(pace / static_cast<double>(scale))
                                     : random.between(slowest, fastest));
    start_phases_.push_back(random.unit());
    tints_.push_back(random_tints(random));
  }
}

void Crowd::give_first_clips(std::uint32_t seed) {
  roles_.assign(size(), Role::walk);
  clips_.assign(size(), character_.clip(Role::walk));
  next_changes_.assign(size(), never);
  whims_.reserve(size());
  for (std::size_t agent = 0; agent < size(); ++agent) {
    whims_.emplace_back(seed, first_whim_stream + agent);
    if (agent < walkers_.size()) continue;
    const StandingClip first = first_standing_clip(agent);
    roles_[agent] = first.role;
    clips_[agent] = first.clip;
    // Uniform from now on, so that the first changes come as evenly as all later ones.
    if (standing_clips_.size() > 1) next_changes_[agent] = some_time(whims_[agent], 0.5F, longest_rest);
  }
}

StandingClip Crowd::first_standing_clip(std::size_t agent) {
  const auto count = static_cast<std::uint32_t>(standing_clips_.size());
  if (count == 0) return {Role::other, no_clip};
  if (standing_clips_[0].role != Role::idle) return standing_clips_[agent % count];
  Random& whim = whims_[agent];
  const bool acts = count > 1 && whim.chance(share_acting_at_first);
  return standing_clips_[acts ? 1 + whim.below(count - 1) : 0];
}

// From idling to one of the other clips and back; without an idle clip, from each to the one after it.
StandingClip Crowd::next_standing_clip(std::size_t agent) {
  const auto count = static_cast<std::uint32_t>(standing_clips_.size());
  if (standing_clips_[0].role == Role::idle) {
    return standing_clips_[roles_[agent] == Role::idle ? 1 + whims_[agent].below(count - 1) : 0];
  }
  const auto current = std::find_if(standing_clips_.begin(), standing_clips_.end(),
                                    [&](const StandingClip& standing) { return standing.clip == clips_[agent]; });
  return standing_clips_[static_cast<std::size_t>(current - standing_clips_.begin() + 1) % count];
}

void Crowd::change_clip(std::size_t agent) {
  const StandingClip next = next_standing_clip(agent);
  Random& whim = whims_[agent];
  roles_[agent] = next.role;
  clips_[agent] = next.clip;
  const bool rests = next.role == Role::idle;
  next_changes_[agent] =
      now_ + some_time(whim, rests ? shortest_rest : shortest_act, rests ? longest_rest : longest_act);
  requests_.push_back(
      {static_cast<std::uint32_t>(agent), next.role, next.clip, whim.between(shortest_fade, longest_fade)});
}

void Crowd::move_walkers() {
  const double seconds = anim::to_seconds(now_);
  for (std::size_t walker = 0; walker < walkers_.size(); ++walker) {
    const Lane& lane = lanes_[walkers_[walker].lane];
    const LanePlace place = lane.at(walkers_[walker].distance + lane.speed * seconds);
    positions_[walker] = {place.position.x, 0.0, place.position.y};
    headings_[walker] = place.heading;
  }
}

std::span<const ClipRequest> Crowd::advance(anim::Ticks dt) {
  assert(dt >= 0);
  now_ += dt;
  move_walkers();
  requests_.clear();
  for (std::size_t agent = walkers_.size(); agent < size(); ++agent) {
    if (now_ >= next_changes_[agent]) change_clip(agent);
  }
  return requests_;
}

CrowdSphere bounding_sphere(const Crowd& crowd) {
  glm::vec3 lowest(0.0F);
  glm::vec3 highest(0.0F);
  for (const glm::vec3& position : crowd.positions()) {
    lowest = glm::min(lowest, position);
    highest = glm::max(highest, position);
  }
  return {(lowest + highest) * 0.5F, glm::distance(lowest, highest) * 0.5F};
}

}  // namespace throng::app
