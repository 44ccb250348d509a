#include "app/people/crowd/minds.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace throng::app {
namespace {

constexpr float shortest_fade = 0.3F, longest_fade = 0.8F;
constexpr float passage_fade = 0.25F;    // seconds, into a clip that leads from one role to another and out of it
constexpr double fastest_passage = 1.1;  // agents in place play no faster, so the clip is left before it is over
constexpr std::uint64_t first_whim_stream = 16;
constexpr Ticks never = std::numeric_limits<Ticks>::max();

Ticks some_time(Random& whim, Stay stay) { return to_ticks(static_cast<double>(whim.between(stay.least, stay.most))); }

}  // namespace

CrowdMinds::CrowdMinds(const CrowdCast& cast, std::vector<Habit> habits, std::uint32_t seed)
    : cast_(&cast), habits_(std::move(habits)) {
  const std::size_t agents = habits_.size();
  intentions_.assign(agents, Role::other);
  roles_.assign(agents, Role::other);
  clips_.assign(agents, no_clip);
  next_changes_.assign(agents, never);
  arrivals_.assign(agents, {never, Role::other, no_clip, false});
  held_.assign(agents, 0);
  whims_.reserve(agents);
  requests_.reserve(agents);
  changed_.reserve(agents);
  for (std::size_t agent = 0; agent < agents; ++agent) {
    whims_.emplace_back(seed, first_whim_stream + agent);
    begin(agent);
  }
}

void CrowdMinds::begin(std::size_t agent) {
  Random& whim = whims_[agent];
  const CharacterRoles& character = cast_->of(agent);
  intentions_[agent] = first_role(habits_[agent], character, whim, thing_of(agent));
  roles_[agent] = Role::other;
  clips_[agent] = no_clip;
  const std::vector<int>& others = character.others;
  if (const auto role = character.playable(intentions_[agent])) {
    roles_[agent] = *role;
    clips_[agent] = character.clip(*role);
  } else if (!others.empty()) {
    clips_[agent] = others[agent % others.size()];
  }
  // Uniform from now on, so that the first changes come as evenly as all later changes.
  const Habit habit = habits_[agent];
  const bool follows =
      habit == Habit::march || habit == Habit::act || habit == Habit::follow || habit == Habit::accompany;
  const bool changes = !follows && (intentions_[agent] != Role::other || others.size() > 1);
  next_changes_[agent] = changes ? now_ + some_time(whim, {0.5F, stay_in(intentions_[agent]).most}) : never;
}

void CrowdMinds::take_new_clips(Ticks now) {
  now_ = now;
  requests_.clear();
  for (std::size_t agent = 0; agent < habits_.size(); ++agent) take_new_clip(agent);
}

/// Returns whether the agent plays a passage to its role that its character still has.
bool CrowdMinds::is_on_its_way(std::size_t agent) const {
  const CharacterRoles& character = cast_->of(agent);
  const Arrival& arrival = arrivals_[agent];
  const int way = arrival.seated ? character.sit_down.clip : character.stand_up.clip;
  return arrival.at != never && clips_[agent] == way && character.clip(arrival.role) == arrival.clip;
}

void CrowdMinds::take_new_clip(std::size_t agent) {
  if (is_on_its_way(agent)) return;
  const CharacterRoles& character = cast_->of(agent);
  const int before = clips_[agent];
  arrivals_[agent].at = never;
  auto played = character.playable(roles_[agent]);
  if (!played) played = character.playable(intentions_[agent]);
  if (played) {
    roles_[agent] = *played;
    clips_[agent] = character.clip(*played);
  } else {
    begin(agent);
  }
  if (clips_[agent] != before) fade_to(agent, roles_[agent], clips_[agent], shortest_fade);
}

void CrowdMinds::decide(Ticks now, std::span<const std::uint32_t> agents) {
  now_ = now;
  requests_.clear();
  changed_.clear();
  for (const std::uint32_t agent : agents) {
    if (!is_due(agent, now)) continue;
    if (now >= arrivals_[agent].at) {
      arrive(agent);
    } else {
      change_role(agent, now);
    }
  }
}

void CrowdMinds::change_role(std::size_t agent, Ticks now) {
  Random& whim = whims_[agent];
  if (intentions_[agent] == Role::other) {
    play_next_other(agent);
  } else {
    const Role next = next_role(habits_[agent], intentions_[agent], cast_->of(agent), whim, thing_of(agent));
    intentions_[agent] = next;
    changed_.push_back(static_cast<std::uint32_t>(agent));
    if (!is_gait(next)) show(agent, next);
  }
  next_changes_[agent] = now + some_time(whim, stay_in(intentions_[agent]));
}

void CrowdMinds::interrupt(std::size_t agent, Role role, Ticks until) {
  if (!cast_->of(agent).playable(role) || holds(agent)) return;
  intentions_[agent] = role;
  next_changes_[agent] = until;
  arrivals_[agent].at = never;
  const Role played = *cast_->of(agent).playable(role);
  const int clip = cast_->of(agent).clip(played);
  if (clip != clips_[agent]) {
    fade_to(agent, played, clip, whims_[agent].between(shortest_fade, longest_fade));
  }
}

std::optional<ClipRequest> CrowdMinds::show_apart(std::size_t agent, Role role) {
  const std::size_t before = requests_.size();
  show(agent, role);
  if (requests_.size() == before) return std::nullopt;
  const ClipRequest request = requests_.back();
  requests_.pop_back();
  return request;
}

std::optional<ClipRequest> CrowdMinds::hold(std::size_t agent) {
  arrivals_[agent].at = never;
  if (std::exchange(held_[agent], std::uint8_t{1}) != 0 || !is_gait(roles_[agent])) return std::nullopt;
  return show_apart(agent, Role::stand);
}

std::optional<ClipRequest> CrowdMinds::release(std::size_t agent) {
  if (std::exchange(held_[agent], std::uint8_t{0}) == 0) return std::nullopt;
  return show_apart(agent, intentions_[agent]);
}

// Without a clip to stand with, the agent plays its other clips in turn.
void CrowdMinds::play_next_other(std::size_t agent) {
  const std::vector<int>& others = cast_->of(agent).others;
  const auto current = std::ranges::find(others, clips_[agent]);
  request(agent, Role::other, others[static_cast<std::size_t>(current - others.begin() + 1) % others.size()]);
}

void CrowdMinds::show(std::size_t agent, Role role) {
  const auto played = cast_->of(agent).playable(role);
  if (!played) return;
  const int clip = cast_->of(agent).clip(*played);
  if (clip == clips_[agent]) {
    roles_[agent] = *played;
  } else {
    request(agent, *played, clip);
  }
}

void CrowdMinds::request(std::size_t agent, Role role, int clip) {
  if (pass(agent, role, clip)) return;
  fade_to(agent, role, clip, whims_[agent].between(shortest_fade, longest_fade));
}

void CrowdMinds::fade_to(std::size_t agent, Role role, int clip, float seconds) {
  roles_[agent] = role;
  clips_[agent] = clip;
  requests_.push_back({static_cast<std::uint32_t>(agent), role, clip, seconds});
}

// Sits down and gets up by the clips for these, where there are any. During such a clip, only the role after it
// changes.
bool CrowdMinds::pass(std::size_t agent, Role role, int clip) {
  Arrival& arrival = arrivals_[agent];
  if (arrival.at != never) {
    arrival = {arrival.at, role, clip, arrival.seated};
    roles_[agent] = role;
    return true;
  }
  const bool sits = role == Role::sit;
  const Passage& passage = sits ? cast_->of(agent).sit_down : cast_->of(agent).stand_up;
  if (sits == (roles_[agent] == Role::sit) || passage.clip == no_clip) return false;
  const double seconds = passage.seconds / fastest_passage - static_cast<double>(passage_fade);
  arrival = {now_ + to_ticks(seconds), role, clip, sits};
  fade_to(agent, role, passage.clip, passage_fade);
  return true;
}

void CrowdMinds::arrive(std::size_t agent) {
  const Arrival arrival = std::exchange(arrivals_[agent], {never, Role::other, no_clip, false});
  roles_[agent] = arrival.seated ? Role::sit : Role::stand;
  if (pass(agent, arrival.role, arrival.clip)) return;  // changed its mind on the way
  fade_to(agent, arrival.role, arrival.clip, passage_fade);
}

}  // namespace throng::app
