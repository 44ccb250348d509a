#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/geometric.hpp>

#include "app/people/crowd/steering/steering.h"

/// Holds the rule of steering for one agent that looks at one body after the other. Lanes must give its bits.
namespace throng::app::plain {

constexpr float horizon = 2.5F;              // seconds that an agent looks ahead
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
class PlainStep {
 public:
  PlainStep(const Body& self, const Wish& wish, const StepRules& rules)
      : self_(self), wish_(wish), rules_(rules), wished_speed_(glm::length(wish.velocity)) {}

  void see(const Body& other) {
    if (other.agent == self_.agent) return;
    const glm::vec2 apart = other.position - self_.position;
    const float square = squared(apart);
    if (square > rules_.sight * rules_.sight) return;
    const float radii = self_.radius + other.radius;
    if (other.company != self_.company) avoid(other, apart, radii, comfort * radii);
    const float close = radii + rules_.closing;
    if (square < close * close) limit(other, apart, std::sqrt(square), {radii, least_share_of_radii * radii});
  }

  void see_obstacle(const Body& obstacle) {
    const glm::vec2 apart = obstacle.position - self_.position;
    const float square = squared(apart), sight = rules_.sight + obstacle.radius;
    if (square > sight * sight) return;
    const float radii = self_.radius + obstacle.radius;
    avoid(obstacle, apart, radii, obstacle.radius + comfort_at_obstacle * self_.radius);
    const float close = radii + rules_.closing;
    if (square < close * close) limit(obstacle, apart, std::sqrt(square), {radii, radii});
  }

  glm::vec2 velocity() {
    if (around_.is_crowded) return glm::vec2(0.0F);
    glm::vec2 velocity = wish_.velocity + no_longer_than(around_.turn_away, 1.2F * wished_speed_);
    velocity = no_longer_than(velocity, wish_.most_speed);
    velocity = politely(velocity);
    // An agent that is held up tries its right.
    const float held_up = wished_speed_ - glm::dot(velocity, with_length(wish_.velocity, 1.0F));
    if (held_up > 0.5F * wished_speed_) {
      velocity = politely(velocity + with_length(right_of(wish_.velocity), sidestep * held_up));
    }
    const float change =
        (squared(velocity) < squared(self_.velocity) ? braking : acceleration) * rules_.spacing * rules_.seconds;
    velocity = self_.velocity + no_longer_than(velocity - self_.velocity, change);
    return kept_apart(no_longer_than(velocity, rules_.most_speed));
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
                                       std::max(0.0F, share * gap / rules_.seconds)};
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
  StepRules rules_;
  float wished_speed_;
  Surroundings around_;
};

}  // namespace throng::app::plain
