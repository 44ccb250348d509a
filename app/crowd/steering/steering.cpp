#include "app/crowd/steering/steering.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/crowd/steering/near_bodies.h"
#include "app/crowd/steering/tiles.h"

namespace throng::app {
namespace {

constexpr float horizon = 2.5F;  // seconds that an agent looks ahead
constexpr float reach_in_spacings = 4.0F;
constexpr float comfort = 1.5F;              // passing distance, in radii summed
constexpr float comfort_at_obstacle = 1.8F;  // passing distance from its edge, in one's own radius
constexpr float avoidance = 1.6F;            // of the wished speed, at the strongest
constexpr float sidestep = 0.6F;             // of the speed that is lost
constexpr float follow_seconds = 0.4F;       // in which the gap to the one ahead may close
constexpr float acceleration = 3.5F;         // metres a second squared, for a person 1.8 m tall
constexpr float braking = 7.0F;
constexpr std::size_t most_close = 32;  // no more discs fit within a step's reach

/// A half-plane of velocities: `velocity . towards` is at most `soft` to be polite and `hard` to stay apart.
struct Limit {
  glm::vec2 towards;
  float soft;
  float hard;
};

/// Metres: as far as an agent looks, and the most by which two come nearer in a step.
struct Reach {
  float sight;
  float closing;
};

/// Metres between the middles of two: where following ends, and where nobody ever is.
struct Distances {
  float polite;
  float least;
};

/// The other agents around one, as limits on its velocity.
struct Surroundings {
  glm::vec2 turn_away{0.0F};  // metres a second
  std::array<Limit, most_close> limits;
  std::size_t close = 0;
  bool is_crowded = false;  // more are close than can be told apart
};

float squared(glm::vec2 vector) { return glm::dot(vector, vector); }

glm::vec2 right_of(glm::vec2 forward) { return {-forward.y, forward.x}; }

glm::vec2 with_length(glm::vec2 vector, float length) {
  const float square = squared(vector);
  return square > 0.0F ? vector * (length / std::sqrt(square)) : glm::vec2(0.0F);
}

glm::vec2 no_longer_than(glm::vec2 vector, float length) {
  return squared(vector) > length * length ? with_length(vector, length) : vector;
}

/// One agent's step.
class Step {
 public:
  Step(const Body& self, const Wish& wish, float seconds, Reach reach)
      : self_(self), wish_(wish), seconds_(seconds), reach_(reach), wished_speed_(glm::length(wish.velocity)) {}

  void see(const Body& other) {
    if (other.agent == self_.agent) return;
    const glm::vec2 apart = other.position - self_.position;
    const float square = squared(apart);
    if (square > reach_.sight * reach_.sight) return;
    const float radii = self_.radius + other.radius;
    if (other.company != self_.company) avoid(other, apart, radii, comfort * radii);
    const float close = radii + reach_.closing;
    if (square < close * close) limit(other, apart, std::sqrt(square), {radii, least_share_of_radii * radii});
  }

  void see_obstacle(const Body& obstacle) {
    const glm::vec2 apart = obstacle.position - self_.position;
    const float square = squared(apart), sight = reach_.sight + obstacle.radius;
    if (square > sight * sight) return;
    const float radii = self_.radius + obstacle.radius;
    avoid(obstacle, apart, radii, obstacle.radius + comfort_at_obstacle * self_.radius);
    const float close = radii + reach_.closing;
    if (square < close * close) limit(obstacle, apart, std::sqrt(square), {radii, radii});
  }

  glm::vec2 velocity(float spacing, float most_speed) {
    if (around_.is_crowded) return glm::vec2(0.0F);
    glm::vec2 velocity = wish_.velocity + no_longer_than(around_.turn_away, 1.2F * wished_speed_);
    velocity = no_longer_than(velocity, wish_.most_speed);
    velocity = politely(velocity);
    // An agent that is held up tries its right.
    const float held_up = wished_speed_ - glm::dot(velocity, with_length(wish_.velocity, 1.0F));
    if (held_up > 0.5F * wished_speed_) {
      velocity = politely(velocity + with_length(right_of(wish_.velocity), sidestep * held_up));
    }
    const float change = (squared(velocity) < squared(self_.velocity) ? braking : acceleration) * spacing * seconds_;
    velocity = self_.velocity + no_longer_than(velocity - self_.velocity, change);
    return kept_apart(no_longer_than(velocity, most_speed));
  }

 private:
  std::span<const Limit> limits() const { return {around_.limits.data(), around_.close}; }

  // Away from where the other will be seen at the closest approach, the sooner and the closer the more.
  void avoid(const Body& other, glm::vec2 apart, float radii, float passing) {
    const glm::vec2 relative = other.velocity - wish_.velocity;
    const float speed_squared = squared(relative);
    const float closing = -glm::dot(apart, relative);
    if (closing <= 0.0F || closing >= horizon * speed_squared) return;
    const float time = closing / speed_squared;
    const glm::vec2 miss = apart + relative * time;
    if (squared(miss) >= passing * passing) return;
    const bool head_on = glm::dot(other.velocity, wish_.velocity) <= 0.0F;
    const glm::vec2 right = right_of(with_length(wish_.velocity, radii));
    const glm::vec2 away = (head_on ? 0.35F : 0.1F) * right - miss;
    const float soon = 1.0F - time / horizon;
    const float close = 1.0F - glm::length(miss) / passing;
    around_.turn_away += with_length(away, avoidance * wished_speed_ * close * soon * soon);
  }

  void limit(const Body& other, glm::vec2 apart, float distance, Distances keep) {
    if (around_.close == most_close) {
      around_.is_crowded = true;
      return;
    }
    const glm::vec2 towards = distance > 0.0F ? apart / distance : glm::vec2(0.0F);
    const float share = other.moves ? 0.5F : 1.0F;
    const float lead = std::max(0.0F, glm::dot(other.velocity, towards));
    const float gap = distance - keep.least;
    around_.limits[around_.close++] = {towards, lead + share * (distance - keep.polite) / follow_seconds,
                                       std::max(0.0F, share * gap / seconds_)};
  }

  // Takes off what is over each limit, one after the other. Few are over any, so it asks first: a velocity that nothing
  // changes does not wait for the limit before.
  glm::vec2 cut(glm::vec2 velocity, float Limit::*most, int passes) const {
    bool is_over = true;
    for (int pass = 0; pass < passes && is_over; ++pass) {
      is_over = false;
      for (const Limit& limit : limits()) {
        const float over = glm::dot(velocity, limit.towards) - limit.*most;
        if (over > 0.0F) {
          velocity -= limit.towards * over;
          is_over = true;
        }
      }
    }
    return velocity;
  }
  glm::vec2 politely(glm::vec2 velocity) const { return cut(velocity, &Limit::soft, 3); }

  glm::vec2 kept_apart(glm::vec2 velocity) const {
    velocity = cut(velocity, &Limit::hard, 2);
    float kept = 1.0F;  // standing still is within every limit, so some part of the way there is too
    for (const Limit& limit : limits()) {
      const float speed = glm::dot(velocity, limit.towards);
      if (speed > limit.hard) kept = std::min(kept, limit.hard / speed);
    }
    return velocity * kept;
  }

  const Body& self_;
  const Wish& wish_;
  float seconds_;
  Reach reach_;
  float wished_speed_;
  Surroundings around_;
};

/// The data that all agents share in a step.
struct StepWork {
  const Steering::Searched* agents;
  const Steering::Searched* obstacles;  // null: there are none
  std::span<Body> bodies;
  std::span<const Wish> wishes;
  float seconds;
  float spacing;
  float most_speed;
  Reach reach;
};

/// Calls `see` for those of the bodies that matter by `job`, in the order of cells.
void see_near(NearBodiesJob job, const Steering::Searched& bodies, const auto& see) {
  const CellRuns runs = bodies.cells.runs_near(job.position);
  if (runs.count == 0) return;
  job.columns = &bodies.columns;
  job.runs = runs.runs();
  NearBodiesCursor cursor;
  NearBodies found;
  bool is_done = false;
  while (!is_done) {
    is_done = find_near_bodies(job, cursor, found);
    for (std::size_t i = 0; i < found.count; ++i) see(bodies.cells.bodies()[found.places[i]]);
  }
}

void move_body(const StepWork& work, const Body& self) {
  const Wish& wish = work.wishes[self.agent];
  Step step(self, wish, work.seconds, work.reach);
  NearBodiesJob job{.position = self.position,
                    .velocity = wish.velocity,
                    .sight = work.reach.sight,
                    .passing_scale = comfort,
                    .passing_offset = self.radius,
                    .close_offset = self.radius,
                    .close_reach = work.reach.closing,
                    .horizon = horizon};
  see_near(job, *work.agents, [&](const Body& other) { step.see(other); });
  if (work.obstacles != nullptr) {
    job.sight_per_radius = 1.0F;
    job.passing_scale = 1.0F;
    job.passing_offset = comfort_at_obstacle * self.radius;
    see_near(job, *work.obstacles, [&](const Body& obstacle) { step.see_obstacle(obstacle); });
  }
  Body& moved = work.bodies[self.agent];
  moved.velocity = step.velocity(work.spacing, work.most_speed);
  moved.position = self.position + moved.velocity * work.seconds;
}

void write_column(const Body& body, std::size_t place, BodyColumns& columns) {
  columns.x[place] = body.position.x;
  columns.z[place] = body.position.y;
  columns.velocity_x[place] = body.velocity.x;
  columns.velocity_z[place] = body.velocity.y;
  columns.radius[place] = body.radius;
}

std::shared_ptr<const Steering::Searched> cells_of(std::span<const Obstacle> obstacles, float reach) {
  if (obstacles.empty()) return nullptr;
  std::vector<Body> bodies;
  glm::vec2 lowest(obstacles.front().position), highest = lowest;
  float largest = 0.0F;
  for (const Obstacle& obstacle : obstacles) {
    bodies.push_back({.position = glm::vec2(obstacle.position),
                      .radius = static_cast<float>(obstacle.radius),
                      .agent = static_cast<std::uint32_t>(bodies.size())});
    lowest = glm::min(lowest, bodies.back().position);
    highest = glm::max(highest, bodies.back().position);
    largest = std::max(largest, bodies.back().radius);
  }
  auto made = std::make_shared<Steering::Searched>();
  made->cells.set_aside(bodies.size(), lowest, highest, reach + largest);
  made->cells.sort(bodies);
  made->columns.set_aside(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) write_column(made->cells.bodies()[i], i, made->columns);
  return made;
}

}  // namespace

Steering::Steering(std::size_t agents, const Ground& ground)
    : ground_(ground), reach_(std::max(reach_in_spacings * ground.spacing, 8.0F * ground.largest_radius)) {
  // Two agents see everybody that both can meet in one step.
  longest_step_ = 0.25F * (reach_ - 2.0F * ground.largest_radius);
  agents_.cells.set_aside(agents, ground.lowest, ground.highest, reach_);
  agents_.columns.set_aside(agents);
  obstacles_ = cells_of(ground.obstacles, reach_);
  ground_.obstacles = {};
}

void Steering::step(std::span<Body> bodies, std::span<const Wish> wishes, float seconds, anim::Executor& executor,
                    int jobs) {
  assert(bodies.size() == wishes.size() && seconds > 0.0F && jobs > 0);
  agents_.cells.sort(bodies);
  float fastest = 0.0F;
  for (const Body& body : bodies) {
    if (body.moves) fastest = std::max(fastest, wishes[body.agent].most_speed);
  }
  if (fastest == 0.0F) return;
  const float most_speed = std::min(fastest, longest_step_ / seconds);
  const float closing_reach = std::max(2.0F * most_speed * seconds, 0.6F * ground_.spacing);
  const StepWork work{.agents = &agents_,
                      .obstacles = obstacles_.get(),
                      .bodies = bodies,
                      .wishes = wishes,
                      .seconds = seconds,
                      .spacing = ground_.spacing,
                      .most_speed = most_speed,
                      .reach = {.sight = reach_, .closing = closing_reach}};
  const std::span<const Body> sorted = agents_.cells.bodies();
  visit_in_tiles(sorted.size(), executor, jobs,
                 [&](std::size_t body) { write_column(sorted[body], body, agents_.columns); });
  visit_in_tiles(sorted.size(), executor, jobs, [&](std::size_t body) {
    if (sorted[body].moves) move_body(work, sorted[body]);
  });
}

}  // namespace throng::app
