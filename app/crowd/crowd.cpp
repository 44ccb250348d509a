#include "app/crowd/crowd.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/crowd/cut_scene_layout.h"
#include "app/crowd/numbers/turn.h"
#include "app/crowd/parade.h"
#include "app/crowd/plaza_plan.h"
#include "app/crowd/resting.h"
#include "app/crowd/stadium.h"
#include "app/crowd/steering/tiles.h"

namespace throng::app {
namespace {

constexpr float least_playback = 0.4F, most_playback = 1.7F;
constexpr int slowness_to_catch_up = 4;  // who is behind makes up one second in so many

// The wave: how long somebody is up, and how unevenly they rise.
constexpr anim::Ticks up_in_wave = anim::ticks_per_second * 9 / 5;
constexpr double wave_unevenness = 0.25;  // seconds

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

bool is_child(const Crowd& crowd, std::size_t agent) {
  const std::vector<BodyKind>& kinds = crowd.cast_.of(agent).bodies;
  return !kinds.empty() && kinds[crowd.looks_.bodies[agent]].is_child();
}

void wear(Crowd& crowd, std::vector<render::AgentLook> looks, std::vector<render::Outfit> outfits,
          std::vector<std::uint16_t> in_hand) {
  assert(looks.size() == crowd.size() && outfits.size() == crowd.size());
  crowd.looks_.drawn = std::move(looks);
  crowd.looks_.outfits = std::move(outfits);
  crowd.looks_.in_hand = std::move(in_hand);
  crowd.looks_.number = render::new_looks_number();
}

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
      route_(layout.route),
      marchers_(layout.marchers),
      looks_(looks_of(layout, scene, seed, cast_, laid_out_for_, variety)),
      state_{.behind = std::vector<anim::Ticks>(marchers_.size()),
             .next_waves = {},
             .minds = CrowdMinds(cast_, habits_of(layout), seed),
             .walkers = walkers_of(layout, looks_, cast_),
             .positions = std::vector<glm::vec3>(looks_.scales.size()),
             .headings = std::vector<Heading>(looks_.scales.size()),
             .speeds = std::vector<float>(looks_.scales.size(), 0.0F),
             .playback_speeds = std::vector<float>(looks_.scales.size(), 1.0F),
             .track_clock = {},
             .absent = {}} {
  due_.set_aside(looks_.scales.size());
  place(layout);
  if (layout.wave_seconds > 0.0) expect_wave(layout);
  if (scene == Scene::tracks) follow(tracks, seed);
}

void Crowd::place(const CrowdLayout& layout) {
  std::size_t agent = walkers();
  for (const MarcherStart& marcher : marchers_) {
    const LanePlace place = marcher_place(route_, marcher, 0.0);
    state_.positions[agent] = {place.position.x, 0.0, place.position.y};
    state_.headings[agent] = place.heading;
    state_.speeds[agent++] = static_cast<float>(route_.speed);
  }
  for (const StanderPlace& place : layout.standers) {
    state_.positions[agent] = {place.position.x, place.height, place.position.y};
    state_.headings[agent++] = place.heading;
  }
  anim::InOrder here;
  follow_walkers(here, 1);
  for (agent = walkers(); agent < size(); ++agent) match_playback(agent);
}

void Crowd::expect_wave(const CrowdLayout& layout) {
  wave_period_ = anim::to_ticks(layout.wave_seconds);
  const anim::Ticks first_wave = anim::to_ticks(layout.wave_begins);
  const std::size_t first_stander = walkers() + marchers();
  for (std::size_t stander = 0; stander < layout.standers.size(); ++stander) {
    const auto unevenness = static_cast<double>(state_.minds.whim(first_stander + stander).between(-1.0F, 1.0F));
    const double after = layout.standers[stander].round * layout.wave_seconds + wave_unevenness * unevenness;
    state_.next_waves.push_back(first_wave + anim::to_ticks(after));
  }
}

// An agent that the front of the wave reaches rises and cheers. Seen from afar, the wave runs round.
void Crowd::lead_wave() {
  const std::size_t first_stander = walkers() + marchers();
  for (std::size_t stander = 0; stander < state_.next_waves.size(); ++stander) {
    if (state_.now < state_.next_waves[stander]) continue;
    const anim::Ticks late = (state_.now - state_.next_waves[stander]) % wave_period_;
    state_.next_waves[stander] = state_.now - late + wave_period_;
    const std::size_t agent = first_stander + stander;
    if (habits()[agent] == Habit::act) continue;
    const Role up = cast_.of(agent).playable(Role::cheer) ? Role::cheer : Role::stand;
    if (late < up_in_wave) state_.minds.interrupt(agent, up, state_.now - late + up_in_wave);
  }
}

void Crowd::match_playback(std::size_t agent) {
  const float own_speed = cast_.speeds_of(agent).own[index_of(roles()[agent])] * scales()[agent];
  state_.playback_speeds[agent] = own_speed > 0.0F
                                      ? std::clamp(state_.speeds[agent] / own_speed, least_playback, most_playback)
                                      : looks_.paces[agent];
}

void Crowd::follow_walkers(anim::Executor& executor, int jobs) {
  visit_in_tiles(walkers(), executor, jobs, [this](std::size_t walker) {
    const Body& body = state_.walkers.bodies()[walker];
    state_.positions[walker] = {body.position.x, 0.0F, body.position.y};
    state_.headings[walker] = state_.walkers.headings()[walker];
    state_.speeds[walker] = glm::length(body.velocity);
    match_playback(walker);
  });
}

double Crowd::marching_time(std::size_t marcher, anim::Ticks dt) {
  anim::Ticks& behind = state_.behind[marcher];
  if (state_.minds.holds(walkers() + marcher)) {
    behind += dt;
  } else {
    behind = std::max(anim::Ticks{}, behind - dt / slowness_to_catch_up);
  }
  return anim::to_seconds(state_.now - behind);
}

void Crowd::march(anim::Ticks dt) {
  for (std::size_t marcher = 0; marcher < marchers_.size(); ++marcher) {
    const std::size_t agent = walkers() + marcher;
    const LanePlace place = marcher_place(route_, marchers_[marcher], marching_time(marcher, dt));
    const glm::vec3 position(place.position.x, 0.0, place.position.y);
    state_.speeds[agent] = static_cast<float>(static_cast<double>(glm::distance(position, state_.positions[agent])) /
                                              anim::to_seconds(dt));
    state_.positions[agent] = position;
    state_.headings[agent] = place.heading;
    match_playback(agent);
  }
}

// The turn of a clip is not in its pose. Who walks or marches turns by the way that it goes.
void Crowd::turn_standers(anim::Ticks dt, anim::Executor& executor, int jobs) {
  const std::size_t movers = walkers() + marchers();
  visit_in_tiles(size() - movers, executor, jobs, [&](std::size_t stander) { turn_stander(movers + stander, dt); });
}

void Crowd::turn_stander(std::size_t agent, anim::Ticks dt) {
  if (state_.minds.holds(agent) || habits()[agent] == Habit::act) return;
  const double quarters_a_second = cast_.of(agent).turn(clips()[agent]);
  if (quarters_a_second == 0.0) return;
  const auto pace = static_cast<double>(state_.playback_speeds[agent]);
  const glm::dvec2 turn = cosine_sine(quarters_a_second * pace * anim::to_seconds(dt));
  const glm::dvec2 before(state_.headings[agent].cosine, state_.headings[agent].sine);
  const glm::dvec2 after(before.x * turn.x - before.y * turn.y, before.y * turn.x + before.x * turn.y);
  const glm::dvec2 unit = after / glm::length(after);
  state_.headings[agent] = {static_cast<float>(unit.x), static_cast<float>(unit.y)};
}

void Crowd::decide(anim::Executor& executor, int jobs) {
  const auto due = due_.gather(size(), executor, jobs, [this](std::size_t agent, std::uint32_t& listed) {
    listed = static_cast<std::uint32_t>(agent);
    return state_.minds.is_due(agent, state_.now);
  });
  state_.minds.decide(state_.now, due);
}

std::span<const ClipRequest> Crowd::advance(anim::Ticks dt, anim::Executor& executor, int jobs) {
  assert(dt >= anim::Ticks{});
  state_.now += dt;
  decide(executor, jobs);
  lead_wave();
  if (dt > anim::Ticks{}) {
    state_.walkers.advance(dt, state_.now, state_.minds, executor, jobs);
    follow_walkers(executor, jobs);
    march(dt);
    turn_standers(dt, executor, jobs);
  }
  if (followers_) {
    app::advance(state_.track_clock, anim::to_seconds(dt));
    follow_tracks(executor, jobs);
  }
  for (const ClipRequest& request : state_.minds.requests()) match_playback(request.agent);
  return state_.minds.requests();
}

std::span<const ClipRequest> Crowd::advance(anim::Ticks dt) {
  anim::InOrder here;
  return advance(dt, here, 1);
}

// Each marcher stays where it is. Its start moves instead, since a place follows from start, speed and time.
void Crowd::march_at(double speed) {
  for (std::size_t marcher = 0; marcher < marchers_.size(); ++marcher) {
    marchers_[marcher].distance += (route_.speed - speed) * anim::to_seconds(state_.now - state_.behind[marcher]);
  }
  route_.speed = speed;
}

std::span<const ClipRequest> Crowd::take_roles(std::span<const CharacterRoles> characters) {
  cast_.take_roles(characters);
  if (!marchers_.empty()) march_at(cast_.of(walkers()).walk_speed);
  state_.minds.take_new_clips(state_.now);
  for (std::size_t agent = 0; agent < size(); ++agent) match_playback(agent);
  return state_.minds.requests();
}

void Crowd::put(std::uint32_t agent, const glm::vec3& position, const Heading& heading) {
  assert(habits()[agent] == Habit::act);
  state_.positions[agent] = position;
  state_.headings[agent] = heading;
}

std::optional<ClipRequest> Crowd::hold(std::uint32_t agent) {
  const auto request = state_.minds.hold(agent);
  state_.speeds[agent] = 0.0F;
  match_playback(agent);
  return request;
}

std::optional<ClipRequest> Crowd::release(std::uint32_t agent) {
  const auto request = state_.minds.release(agent);
  match_playback(agent);
  return request;
}

void Crowd::go_back_to(const CrowdMoment& moment) {
  assert(moment->positions.size() == size());
  state_ = *moment;
}

glm::vec3 middle_of(const Crowd& crowd) {
  glm::vec3 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const glm::vec3& foot = crowd.positions()[agent];
    const float beside = crowd.radii()[agent];
    const float above = static_cast<float>(crowd.cast_.of(agent).height) * crowd.scales()[agent];
    lowest = glm::min(lowest, foot - glm::vec3(beside, 0.0F, beside));
    highest = glm::max(highest, foot + glm::vec3(beside, above, beside));
  }
  return (lowest + highest) * 0.5F;
}

}  // namespace throng::app
