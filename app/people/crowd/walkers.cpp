#include "app/people/crowd/walkers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr Ticks longest_step = ticks_per_second / 30;
constexpr int most_steps = 64;
constexpr Ticks least_time_in_gait = ticks_per_second * 3 / 5;
constexpr Ticks patience = ticks_per_second * 3;  // until a walker that is stuck goes another way

constexpr float lead_in_spacings = 1.2F, lead_seconds = 0.6F;
constexpr float aside_in_spacings = 3.0F;
constexpr double lead_step = 0.25;      // metres
constexpr float farthest_lane = 22.0F;  // metres to another lane
constexpr float chance_of_another_way = 0.5F;
constexpr float standing_speed = 0.05F;  // metres a second
// Company keeps to these metres of a person, seconds, and shares of a speed.
constexpr float behind_leader = 0.05F, near_enough = 0.35F, seconds_to_come_up = 0.8F;
constexpr float most_hurry = 1.35F, slower_a_metre = 0.45F, least_of_speed = 0.35F;
constexpr float share_of_walk_to_step = 0.25F;
constexpr float gait_band = 1.08F;  // by which a speed must leave a gait's range
constexpr double turns_a_second = 0.75;

glm::vec2 on_ground(const LanePoint& place) { return {place.position}; }

std::pair<glm::vec2, glm::vec2> extent_of(std::span<const Body> bodies) {
  glm::vec2 lowest(std::numeric_limits<float>::max()), highest(std::numeric_limits<float>::lowest());
  for (const Body& body : bodies) {
    lowest = glm::min(lowest, body.position);
    highest = glm::max(highest, body.position);
  }
  return {lowest, highest};
}

Steering::Ground ground_of(std::span<const Body> bodies, float spacing, std::span<const Obstacle> obstacles) {
  const auto [lowest, highest] = extent_of(bodies);
  float largest = 0.0F;
  for (const Body& body : bodies) largest = std::max(largest, body.radius);
  return {lowest, highest, largest, spacing, obstacles};
}

// Turns from one heading towards another, by one turn at most.
Heading turned(Heading from, Heading to, glm::vec2 most) {
  const float cosine = from.cosine * to.cosine + from.sine * to.sine;
  if (cosine >= most.x) return to;
  const float side = from.cosine * to.sine - from.sine * to.cosine < 0.0F ? -most.y : most.y;
  const float c = from.cosine * most.x - from.sine * side, s = from.sine * most.x + from.cosine * side;
  const float length = std::sqrt(c * c + s * s);
  return {c / length, s / length};
}

}  // namespace

CrowdWalkers::CrowdWalkers(const CrowdCast& cast, std::vector<Lane> lanes, std::vector<WalkerStart> starts,
                           std::vector<Body> bodies, std::vector<float> paces, Company company,
                           std::span<const Obstacle> obstacles)
    : cast_(&cast),
      spacing_(static_cast<float>(cast.spacing())),
      lanes_(std::move(lanes)),
      starts_(std::move(starts)),
      ahead_(starts_.size()),
      paces_(std::move(paces)),
      company_(std::move(company)),
      headings_(starts_.size()),
      moved_at_(starts_.size()),
      new_gait_at_(starts_.size()),
      bodies_(std::move(bodies)),
      wishes_(bodies_.size()),
      next_gaits_(starts_.size(), Role::other) {
  assert(paces_.size() == starts_.size() && bodies_.size() >= starts_.size());
  if (starts_.empty()) return;
  for (std::size_t walker = 0; walker < count(); ++walker) begin_walking(walker);
  steering_ = Steering(bodies_.size(), ground_of(bodies_, spacing_, obstacles));
}

void CrowdWalkers::begin_walking(std::size_t walker) {
  const WalkerStart& start = starts_[walker];
  const LanePoint place = lanes_[start.lane].at(start.distance);
  headings_[walker] = place.heading;
  ahead_[walker] = bodies_[walker].position = on_ground(place);
  if (company_.follows(walker)) bodies_[walker].position = place_beside(walker);
  bodies_[walker].moves = true;
  bodies_[walker].velocity = glm::vec2(place.heading.sine, place.heading.cosine) * speed_of(walker, Role::walk);
}

float CrowdWalkers::speed_of(std::size_t walker, Role gait) const {
  return cast_->speeds_of(walker).played[index_of(gait)] * paces_[walker];
}

// Goes to the nearest of a few places on another lane, if one is near enough.
void CrowdWalkers::set_out(std::size_t walker, Random& whim) {
  constexpr int tries = 4, places = 8;
  const glm::vec2 here = bodies_[walker].position;
  for (int i = 0; i < tries; ++i) {
    const std::uint32_t lane = whim.below(static_cast<std::uint32_t>(lanes_.size()));
    if (lane == starts_[walker].lane) continue;
    const double length = lanes_[lane].length();
    float nearest = farthest_lane * spacing_;
    WalkerStart chosen = starts_[walker];
    for (int place = 0; place < places; ++place) {
      const WalkerStart candidate{lane, length * place / places};
      const float away = glm::distance(on_ground(lanes_[lane].at(candidate.distance)), here);
      if (away >= nearest) continue;
      nearest = away;
      chosen = candidate;
    }
    if (chosen.lane != lane) continue;
    starts_[walker] = chosen;
    ahead_[walker] = on_ground(lanes_[lane].at(chosen.distance));
    return;
  }
}

// Goes a few steps in any direction, then to another lane. So an agent that is hemmed in gets out.
void CrowdWalkers::turn_aside(std::size_t walker, Random& whim) {
  set_out(walker, whim);
  const glm::vec2 direction(cosine_sine(4.0 * static_cast<double>(whim.unit())));
  ahead_[walker] = bodies_[walker].position + direction * (aside_in_spacings * spacing_);
}

void CrowdWalkers::look_ahead(std::size_t walker) {
  WalkerStart& way = starts_[walker];
  const Lane& lane = lanes_[way.lane];
  const float by_speed = lead_in_spacings * spacing_ + lead_seconds * glm::length(bodies_[walker].velocity);
  const float lead = std::min(by_speed, 0.2F * static_cast<float>(lane.length()));
  for (int step = 0; step < 64 && glm::distance(ahead_[walker], bodies_[walker].position) < lead; ++step) {
    way.distance += lead_step * static_cast<double>(spacing_);
    ahead_[walker] = on_ground(lane.at(way.distance));
  }
}

// The place beside the leader, a little behind, so that the companion sees where the leader goes.
glm::vec2 CrowdWalkers::place_beside(std::size_t walker) const {
  const std::size_t leader = company_.leader(walker);
  const Heading heading = headings_[leader];
  const glm::vec2 left(heading.cosine, -heading.sine), ahead(heading.sine, heading.cosine);
  return bodies_[leader].position + spacing_ * (company_.sides[walker] * left - behind_leader * ahead);
}

// A follower on the wrong side, because the leader has turned, goes round behind the leader, who is in the way.
glm::vec2 CrowdWalkers::way_beside(std::size_t walker) const {
  constexpr float round_behind = 0.8F;
  const std::size_t leader = company_.leader(walker);
  const Heading heading = headings_[leader];
  const glm::vec2 left(heading.cosine, -heading.sine), ahead(heading.sine, heading.cosine);
  const glm::vec2 from_leader = bodies_[walker].position - bodies_[leader].position;
  const float side = company_.sides[walker];
  if (glm::dot(from_leader, left) * side >= 0.0F) return place_beside(walker) - bodies_[walker].position;
  return spacing_ * (0.4F * side * left - round_behind * ahead) - from_leader;
}

// The companion comes up faster than the leader goes, and stands once it is there and the leader stands.
void CrowdWalkers::keep_company(std::size_t walker) {
  Body& body = bodies_[walker];
  const Body& leader = bodies_[company_.leader(walker)];
  const glm::vec2 way = way_beside(walker);
  const float most = most_hurry * std::max(speed_of(walker, Role::walk), glm::length(leader.velocity));
  glm::vec2 velocity = leader.velocity + way / seconds_to_come_up;
  const float speed = glm::length(velocity);
  if (speed > most) velocity *= most / speed;
  const bool is_there = !leader.moves && glm::length(way) < near_enough * spacing_;
  if (is_there) velocity = glm::vec2(0.0F);
  body.moves = !is_there || glm::length(body.velocity) > standing_speed;
  if (!body.moves) body.velocity = glm::vec2(0.0F);
  wishes_[walker] = {velocity, body.moves ? std::max(most, glm::length(body.velocity)) : 0.0F};
}

// A leader goes no faster than the slowest of its company can, and waits for companions behind.
float CrowdWalkers::patient_speed(std::size_t leader, float speed) const {
  for (std::size_t walker = leader + 1; walker < company_.end_of(leader); ++walker) {
    const float behind = glm::distance(place_beside(walker), bodies_[walker].position) / spacing_;
    const float waits = std::clamp(1.0F - slower_a_metre * (behind - near_enough), least_of_speed, 1.0F);
    speed = std::min(speed, most_hurry * speed_of(walker, Role::walk)) * waits;
  }
  return speed;
}

void CrowdWalkers::wish(std::size_t walker, Role intention) {
  if (company_.follows(walker)) return keep_company(walker);
  Body& body = bodies_[walker];
  if (!is_gait(intention)) {
    body.moves = glm::length(body.velocity) > standing_speed;
    if (!body.moves) body.velocity = glm::vec2(0.0F);
    wishes_[walker] = {glm::vec2(0.0F), body.moves ? glm::length(body.velocity) : 0.0F};
    return;
  }
  look_ahead(walker);
  const glm::vec2 way = ahead_[walker] - body.position;
  const float left = std::max(glm::length(way), 1e-3F);
  const float speed = patient_speed(walker, speed_of(walker, intention));
  body.moves = true;
  wishes_[walker] = {way * (speed / left), 1.15F * speed};
}

void CrowdWalkers::stop(std::size_t walker) {
  bodies_[walker].moves = false;
  bodies_[walker].velocity = glm::vec2(0.0F);
  wishes_[walker] = {};
}

// `most` is the cosine and sine of the largest angle that a walker turns by in a step.
void CrowdWalkers::turn(std::size_t walker, glm::vec2 most) {
  const glm::vec2 velocity = bodies_[walker].velocity;
  const float speed = glm::length(velocity);
  if (speed < standing_speed) return;
  headings_[walker] = turned(headings_[walker], {velocity.y / speed, velocity.x / speed}, most);
}

// The gait whose range the speed is in; a little beyond it, still the one that is shown.
Role CrowdWalkers::gait(std::size_t walker, Role shown) const {
  const float speed = glm::length(bodies_[walker].velocity);
  Role fitting = Role::walk;
  for (const Role faster : {Role::jog, Role::run}) {
    if (cast_->speeds_of(walker).own[index_of(faster)] == 0.0F) continue;
    const float border = std::sqrt(speed_of(walker, fitting) * speed_of(walker, faster));
    const bool is_shown = is_gait(shown) && shown >= faster;
    if (speed > (is_shown ? border / gait_band : border * gait_band)) fitting = faster;
  }
  return fitting;
}

/// Returns the gait that a walker goes over to, or Role::other. A walker that is stuck for long goes another way.
Role CrowdWalkers::next_gait(std::size_t walker, Ticks now, CrowdMinds& minds) {
  const Role shown = minds.roles()[walker];
  const bool steps = glm::length(bodies_[walker].velocity) > share_of_walk_to_step * speed_of(walker, Role::walk);
  if (steps) moved_at_[walker] = now;
  if (now - new_gait_at_[walker] < least_time_in_gait) return Role::other;
  const Ticks held_up = now - moved_at_[walker];
  if (!company_.follows(walker) && held_up >= patience && now - new_gait_at_[walker] >= patience) {
    new_gait_at_[walker] = now;
    turn_aside(walker, minds.whim(walker));
    return Role::other;
  }
  const bool is_held_up = held_up > least_time_in_gait;
  const Role fitting = is_held_up ? Role::stand : gait(walker, shown);
  if (fitting == shown || (fitting == Role::stand && !cast_->of(walker).playable(fitting))) return Role::other;
  new_gait_at_[walker] = now;
  return fitting;
}

// Few walkers change, and their requests come in the order of the agents.
void CrowdWalkers::show_gaits(Ticks now, CrowdMinds& minds, Executor& executor, int jobs) {
  visit_in_tiles(count(), executor, jobs, [&](std::size_t walker) {
    const bool goes = is_gait(minds.intentions()[walker]) && !minds.holds(walker);
    next_gaits_[walker] = goes ? next_gait(walker, now, minds) : Role::other;
  });
  for (std::size_t walker = 0; walker < count(); ++walker) {
    if (next_gaits_[walker] != Role::other) minds.show(walker, next_gaits_[walker]);
  }
}

/// Decides for a leader and then for its company, in one job, because companions read what the leader has decided.
void CrowdWalkers::wish_together(std::size_t leader, const CrowdMinds& minds) {
  for (std::size_t walker = leader; walker < company_.end_of(leader); ++walker) {
    if (minds.holds(walker)) {
      stop(walker);
    } else {
      wish(walker, minds.intentions()[walker]);
    }
  }
}

void CrowdWalkers::advance(Ticks dt, Ticks now, CrowdMinds& minds, Executor& executor, int jobs) {
  if (starts_.empty() || dt <= Ticks{}) return;
  for (const std::uint32_t agent : minds.changed()) {
    if (agent >= count() || !is_gait(minds.intentions()[agent])) continue;
    moved_at_[agent] = now;
    if (minds.whim(agent).chance(chance_of_another_way)) set_out(agent, minds.whim(agent));
  }
  const auto steps =
      static_cast<int>(std::min<std::int64_t>((dt + longest_step - Ticks{1}) / longest_step, most_steps));
  const auto seconds = static_cast<float>(to_seconds(dt) / steps);
  const glm::vec2 most_turn(cosine_sine(4.0 * turns_a_second * static_cast<double>(seconds)));
  for (int step = 0; step < steps; ++step) {
    visit_in_tiles(count(), executor, jobs, [&](std::size_t walker) {
      if (!company_.follows(walker)) wish_together(walker, minds);
    });
    steering_.step(bodies_, wishes_, seconds, executor, jobs);
    visit_in_tiles(count(), executor, jobs, [&](std::size_t walker) { turn(walker, most_turn); });
  }
  show_gaits(now, minds, executor, jobs);
}

}  // namespace throng::app
