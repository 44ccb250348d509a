#include "app/people/crowd/steering/steering.h"

#include <algorithm>
#include <array>
#include <cassert>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/steering/near_bodies.h"
#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr float reach_in_spacings = 4.0F;

/// The data that all agents share in a step.
struct StepWork {
  const Steering::Searched* agents;
  const ObstacleMap* obstacles;  // null: there are none
  std::span<Body> bodies;
  std::span<const Wish> wishes;
  StepRules rules;
};

/// Walkers side by side, and their numbers.
struct WalkersInStrip {
  StepStrip strip;
  StepStrip::Numbers agents{};

  void add(const Body& self, const Wish& wish, std::size_t place) {
    const std::size_t lane = strip.count++;
    agents[lane] = self.agent;
    strip.x[lane] = self.position.x;
    strip.z[lane] = self.position.y;
    strip.velocity_x[lane] = self.velocity.x;
    strip.velocity_z[lane] = self.velocity.y;
    strip.radius[lane] = self.radius;
    strip.wish_x[lane] = wish.velocity.x;
    strip.wish_z[lane] = wish.velocity.y;
    strip.most_speed[lane] = wish.most_speed;
    strip.company[lane] = self.company;
    strip.place[lane] = static_cast<std::uint32_t>(place);
  }

  void write(std::span<Body> bodies) const {
    for (std::size_t lane = 0; lane < strip.count; ++lane) {
      Body& moved = bodies[agents[lane]];
      moved.velocity = {strip.velocity_x[lane], strip.velocity_z[lane]};
      moved.position = {strip.x[lane], strip.z[lane]};
    }
  }
};

/// Searches bodies for all walkers of a strip, in goes where many matter to one of them. `Bodies` has columns() and
/// runs_near().
template <typename Bodies>
class StripSearch {
 public:
  StripSearch(const StepStrip& strip, const Bodies& bodies, const SeeJob& job)
      : strip_(&strip), bodies_(&bodies), keeps_(job.keeps), rules_(job.rules) {}

  /// Finds the next bodies of each lane. Returns whether there may be more.
  bool find(FoundByLane& found) {
    bool is_done = true;
    for (std::size_t lane = 0; lane < strip_->count; ++lane) {
      found.count[lane] = 0;
      if (!is_lane_done_[lane]) is_lane_done_[lane] = find_of(lane, found);
      is_done = is_done && is_lane_done_[lane];
    }
    return !is_done;
  }

 private:
  bool find_of(std::size_t lane, FoundByLane& found) {
    const glm::vec2 position(strip_->x[lane], strip_->z[lane]);
    const CellRuns runs = bodies_->runs_near(position);
    if (runs.count == 0) return true;
    const float radius = strip_->radius[lane];
    NearBodies near;
    const bool is_done = find_near_bodies({.columns = &bodies_->columns(),
                                           .runs = runs.runs(),
                                           .position = position,
                                           .velocity = {strip_->wish_x[lane], strip_->wish_z[lane]},
                                           .sight = rules_.sight,
                                           .sight_per_radius = keeps_.sight_per_radius,
                                           .passing_scale = keeps_.passing_scale,
                                           .passing_offset = keeps_.passing_per_radius * radius,
                                           .close_offset = radius,
                                           .close_reach = rules_.closing,
                                           .horizon = steering_horizon},
                                          cursors_[lane], near);
    for (std::size_t k = 0; k < near.count; ++k) found.places[k][lane] = near.places[k];
    found.count[lane] = static_cast<std::uint32_t>(near.count);
    return is_done;
  }

  const StepStrip* strip_;
  const Bodies* bodies_;
  KeptDistances keeps_;
  StepRules rules_;
  std::array<NearBodiesCursor, StepStrip::lanes> cursors_{};
  std::array<bool, StepStrip::lanes> is_lane_done_{};
};

template <typename Bodies>
void see_all(const Bodies& bodies, SeeJob job, StepStrip& strip) {
  StripSearch<Bodies> search(strip, bodies, job);
  FoundByLane found;
  job.bodies = &bodies.columns();
  job.found = &found;
  bool goes_on = true;
  while (goes_on) {
    goes_on = search.find(found);
    see(job, strip);
  }
}

void move_strip(const StepWork& work, WalkersInStrip& walkers) {
  see_all(*work.agents, {.keeps = kept_from_agents, .rules = work.rules}, walkers.strip);
  if (work.obstacles != nullptr) {
    see_all(*work.obstacles, {.keeps = kept_from_obstacles, .rules = work.rules}, walkers.strip);
  }
  take_step(work.rules, walkers.strip);
  walkers.write(work.bodies);
}

void move_tile(const StepWork& work, std::size_t first, std::size_t end) {
  const std::span<const Body> sorted = work.agents->bodies();
  std::size_t place = first;
  while (place < end) {
    WalkersInStrip walkers;
    for (; place < end && walkers.strip.count < StepStrip::lanes; ++place) {
      if (sorted[place].moves) walkers.add(sorted[place], work.wishes[sorted[place].agent], place);
    }
    if (walkers.strip.count > 0) move_strip(work, walkers);
  }
}

}  // namespace

Steering::Steering(std::size_t agents, const Ground& ground)
    : ground_(ground), reach_(std::max(reach_in_spacings * ground.spacing, 8.0F * ground.largest_radius)) {
  // Two agents see every agent that both can meet in one step.
  longest_step_ = 0.25F * (reach_ - 2.0F * ground.largest_radius);
  agents_.set_aside(agents, ground.lowest, ground.highest, reach_);
  if (!ground.obstacles.empty()) {
    obstacles_ = std::make_shared<ObstacleMap>(ground.obstacles, ground.lowest, ground.highest, reach_);
  }
  ground_.obstacles = {};
}

void Steering::step(std::span<Body> bodies, std::span<const Wish> wishes, float seconds, Executor& executor, int jobs) {
  assert(bodies.size() == wishes.size() && seconds > 0.0F && jobs > 0);
  const float fastest = agents_.sort(bodies, wishes, executor, jobs);
  if (fastest == 0.0F) return;
  const float most_speed = std::min(fastest, longest_step_ / seconds);
  const float closing_reach = std::max(2.0F * most_speed * seconds, 0.6F * ground_.spacing);
  const StepWork work{.agents = &agents_,
                      .obstacles = obstacles_.get(),
                      .bodies = bodies,
                      .wishes = wishes,
                      .rules = {.seconds = seconds,
                                .spacing = ground_.spacing,
                                .most_speed = most_speed,
                                .sight = reach_,
                                .closing = closing_reach}};
  visit_tiles(bodies.size(), executor, jobs, [&](std::size_t first, std::size_t end) { move_tile(work, first, end); });
}

}  // namespace throng::app
