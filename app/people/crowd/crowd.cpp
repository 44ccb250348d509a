#include "app/people/crowd/crowd.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/cut_scene_layout.h"
#include "app/people/crowd/numbers/turn.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/crowd/resting.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr float least_playback = 0.4F, most_playback = 1.7F;

CrowdLayout layout_of(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                      Clothes clothes) {
  switch (scene) {
    case Scene::plaza:
      return plaza_layout(agents, seed, roles, clothes);
    case Scene::parade:
      return parade_layout(agents, seed, roles);
    case Scene::stadium:
      return stadium_layout(agents, seed, roles);
    case Scene::grid:
      break;
    case Scene::film:
      return cut_scene_layout(agents, seed, roles);
    case Scene::tracks:
      return followers_layout(agents);
  }
  return grid_layout(agents, roles);
}

CrowdLayout layout_with_company(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                                const Variety& variety) {
  CrowdLayout layout = layout_of(scene, agents, seed, roles, variety.clothes);
  if (!variety.bodies) return layout;
  draw_company(layout, seed);
  if (scene != Scene::plaza || variety.clothes != Clothes::own) return layout;
  let_some_rest(layout, agents, seed, roles);
  draw_gatherings(layout, sights_of(layout.fixtures), roles.spacing(), seed);
  return layout;
}

CrowdWalkers walkers_of(const CrowdLayout& layout, const CrowdLooks& looks, const CrowdCast& cast) {
  std::vector<Body> bodies;
  for (std::size_t agent = 0; agent < looks.radii.size(); ++agent) {
    const auto number = static_cast<std::uint32_t>(agent);
    const bool walks = agent < layout.walkers.size();
    bodies.push_back({.radius = looks.radii[agent],
                      .agent = number,
                      .company = walks ? static_cast<std::uint32_t>(layout.company.leader(agent)) : number});
  }
  const std::size_t first_stander = layout.walkers.size() + layout.marchers.size();
  for (std::size_t stander = 0; stander < layout.standers.size(); ++stander) {
    bodies[first_stander + stander].position = layout.standers[stander].position;
  }
  std::vector<float> paces;
  for (std::size_t walker = 0; walker < layout.walkers.size(); ++walker) {
    paces.push_back(looks.paces[walker] * looks.scales[walker]);
  }
  return {cast, layout.lanes, layout.walkers, std::move(bodies), std::move(paces), layout.company, layout.obstacles};
}

}  // namespace

Crowd::Crowd(Scene scene, std::size_t agents, std::uint32_t seed, std::span<const CharacterRoles> characters,
             const Variety& variety, const TrackSource& tracks)
    : Crowd(layout_with_company(scene, agents, seed, common_roles(characters), variety), scene, seed, characters,
            variety, tracks, common_roles(characters)) {
  assert(size() == agents);
}

Crowd::Crowd(const CrowdLayout& layout, Scene scene, std::uint32_t seed, std::span<const CharacterRoles> characters,
             const Variety& variety, const TrackSource& tracks, CharacterRoles common)
    : laid_out_for_(std::move(common)),
      cast_(characters, layout, seed),
      looks_(looks_of(layout, scene, seed, cast_, laid_out_for_, variety)),
      state_{.now = {},
             .places = {.positions = std::vector<glm::vec3>(looks_.scales.size()),
                        .headings = std::vector<Heading>(looks_.scales.size()),
                        .speeds = std::vector<float>(looks_.scales.size(), 0.0F),
                        .playback_speeds = std::vector<float>(looks_.scales.size(), 1.0F)},
             .minds = CrowdMinds(cast_, habits_of(layout), seed),
             .walkers = walkers_of(layout, looks_, cast_),
             .marchers = Marchers(layout),
             .wave = {},
             .tracks = {}} {
  due_.set_aside(looks_.scales.size());
  place(layout);
  if (layout.wave_seconds > 0.0) state_.wave = Wave(layout, state_.minds);
  if (scene != Scene::tracks) return;
  state_.tracks.emplace(tracks, cast_, looks_.scales, seed);
  InOrder here;
  follow_tracks(here, 1);
}

void Crowd::place(const CrowdLayout& layout) {
  state_.marchers.begin(state_.places);
  for (std::size_t agent = first_stander(); const StanderStart& place : layout.standers) {
    state_.places.positions[agent] = {place.position.x, place.height, place.position.y};
    state_.places.headings[agent++] = place.heading;
  }
  InOrder here;
  follow_walkers(here, 1);
  for (std::size_t agent = walkers().count(); agent < size(); ++agent) match_playback(agent);
}

void Crowd::match_playback(std::size_t agent) {
  const float own_speed = cast_.speeds_of(agent).own[index_of(minds().roles()[agent])] * scales()[agent];
  state_.places.playback_speeds[agent] =
      own_speed > 0.0F ? std::clamp(state_.places.speeds[agent] / own_speed, least_playback, most_playback)
                       : looks_.paces[agent];
}

void Crowd::follow_walkers(Executor& executor, int jobs) {
  visit_in_tiles(walkers().count(), executor, jobs, [this](std::size_t walker) {
    const Body& body = state_.walkers.bodies()[walker];
    state_.places.positions[walker] = {body.position.x, 0.0F, body.position.y};
    state_.places.headings[walker] = state_.walkers.headings()[walker];
    state_.places.speeds[walker] = glm::length(body.velocity);
    match_playback(walker);
  });
}

void Crowd::march(Ticks dt) {
  state_.marchers.advance(dt, state_.now, state_.minds, state_.places);
  for (std::size_t agent = walkers().count(); agent < first_stander(); ++agent) match_playback(agent);
}

void Crowd::follow_tracks(Executor& executor, int jobs) {
  state_.tracks->place(cast_, looks_.scales, state_.places, state_.minds, executor, jobs);
}

// The turn of a clip is not in its pose. An agent that walks or marches turns by its way instead.
void Crowd::turn_stander(std::size_t agent, Ticks dt) {
  if (state_.minds.holds(agent) || minds().habits()[agent] == Habit::act) return;
  const double quarters_a_second = cast_.of(agent).turn(minds().clips()[agent]);
  if (quarters_a_second == 0.0) return;
  const auto pace = static_cast<double>(state_.places.playback_speeds[agent]);
  const glm::dvec2 turn = cosine_sine(quarters_a_second * pace * to_seconds(dt));
  const glm::dvec2 before(state_.places.headings[agent].cosine, state_.places.headings[agent].sine);
  const glm::dvec2 after(before.x * turn.x - before.y * turn.y, before.y * turn.x + before.x * turn.y);
  const glm::dvec2 unit = after / glm::length(after);
  state_.places.headings[agent] = {static_cast<float>(unit.x), static_cast<float>(unit.y)};
}

void Crowd::decide(Executor& executor, int jobs) {
  const auto due = due_.gather(size(), executor, jobs, [this](std::size_t agent, std::uint32_t& listed) {
    listed = static_cast<std::uint32_t>(agent);
    return state_.minds.is_due(agent, state_.now);
  });
  state_.minds.decide(state_.now, due);
}

std::span<const ClipRequest> Crowd::advance(Ticks dt, Executor& executor, int jobs) {
  assert(dt >= Ticks{});
  state_.now += dt;
  decide(executor, jobs);
  state_.wave.advance(state_.now, cast_, state_.minds);
  if (dt > Ticks{}) {
    state_.walkers.advance(dt, state_.now, state_.minds, executor, jobs);
    follow_walkers(executor, jobs);
    march(dt);
    const std::size_t stander = first_stander();
    visit_in_tiles(size() - stander, executor, jobs, [&](std::size_t i) { turn_stander(stander + i, dt); });
  }
  if (state_.tracks) {
    state_.tracks->advance(dt);
    follow_tracks(executor, jobs);
  }
  for (const ClipRequest& request : state_.minds.requests()) match_playback(request.agent);
  return state_.minds.requests();
}

std::span<const ClipRequest> Crowd::advance(Ticks dt) {
  InOrder here;
  return advance(dt, here, 1);
}

std::span<const ClipRequest> Crowd::take_roles(std::span<const CharacterRoles> characters) {
  cast_.take_roles(characters);
  if (marchers().count() > 0) state_.marchers.take_speed(cast_.of(walkers().count()).walk_speed, state_.now);
  state_.minds.take_new_clips(state_.now);
  for (std::size_t agent = 0; agent < size(); ++agent) match_playback(agent);
  return state_.minds.requests();
}

void Crowd::put(std::uint32_t agent, const glm::vec3& position, const Heading& heading) {
  assert(minds().habits()[agent] == Habit::act);
  state_.places.positions[agent] = position;
  state_.places.headings[agent] = heading;
}

std::optional<ClipRequest> Crowd::hold(std::uint32_t agent) {
  const auto request = state_.minds.hold(agent);
  state_.places.speeds[agent] = 0.0F;
  match_playback(agent);
  return request;
}

std::optional<ClipRequest> Crowd::release(std::uint32_t agent) {
  const auto request = state_.minds.release(agent);
  match_playback(agent);
  return request;
}

void Crowd::go_to(const TrackClock& clock) {
  state_.tracks->set_clock(clock);
  InOrder here;
  follow_tracks(here, 1);
}

void Crowd::take(const LiveStep& step, Executor& executor, int jobs) {
  state_.tracks->take(step, cast_, looks_.scales, executor, jobs);
}

void Crowd::go_back_to(const CrowdState& moment) {
  assert(moment.places.positions.size() == size());
  state_ = moment;
}

bool is_child(const Crowd& crowd, std::size_t agent) {
  const std::vector<BodyKind>& kinds = crowd.cast().of(agent).bodies;
  return !kinds.empty() && kinds[crowd.looks().bodies[agent]].is_child();
}

glm::vec3 middle_of(const Crowd& crowd) {
  glm::vec3 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const glm::vec3& foot = crowd.positions()[agent];
    const float beside = crowd.looks().radii[agent];
    const float above = static_cast<float>(crowd.cast().of(agent).height) * crowd.scales()[agent];
    lowest = glm::min(lowest, foot - glm::vec3(beside, 0.0F, beside));
    highest = glm::max(highest, foot + glm::vec3(beside, above, beside));
  }
  return (lowest + highest) * 0.5F;
}

}  // namespace throng::app
