#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>

#include <glm/vec2.hpp>

#include "throng/host.h"

#include "app/people/crowd/steering/cells.h"
#include "app/people/crowd/steering/obstacle_map.h"
#include "app/people/crowd/steering/step_strip.h"

namespace throng::app {

/// The velocity that an agent would have if no other was in its way.
struct Wish {
  glm::vec2 velocity{0.0F};  ///< metres a second
  float most_speed = 0.0F;   ///< metres a second, also while it makes way; above 0 for bodies that move
};

/// Lets agents walk around each other. Each looks at where all were when the step began, so the agents can be computed
/// in any order and on any number of PUs with the same result to the last bit.
///
/// An agent turns away from agents it would come too close to (time and place of closest approach; to its right from
/// agents that come head-on), follows no faster than the agents ahead, and accelerates within limits. Its velocity is
/// then cut to the half-planes of its buffered Voronoi cell (Zhou et al. 2017), whose origin is always free. Each of
/// two agents may take half of the gap between them, or all of it where the other stands. So agents never collide, even
/// in a dense crowd. Obstacles are bodies that always stand; no feet come closer to one than their own share.
class Steering {
 public:
  struct Ground {
    glm::vec2 lowest{0.0F}, highest{0.0F};     ///< metres, where agents are as a rule
    float largest_radius = 0.3F;               ///< metres
    float spacing = 1.0F;                      ///< CharacterRoles::spacing; lengths and accelerations grow with it
    std::span<const Obstacle> obstacles = {};  ///< read by the constructor alone
  };

  /// Agents that are searched: sorted by cell, and their columns in that order.
  class Searched : CrowdCells {
   public:
    using CrowdCells::bodies, CrowdCells::runs_near;
    void set_aside(std::size_t agents, glm::vec2 lowest, glm::vec2 highest, float reach) {
      CrowdCells::set_aside(agents, lowest, highest, reach);
      columns_.set_aside(agents);
    }
    const BodyColumns& columns() const { return columns_; }
    /// Returns the highest speed that a moving agent wishes for.
    float sort(std::span<const Body> agents, std::span<const Wish> wishes, Executor& executor, int jobs) {
      std::atomic<float> fastest{0.0F};
      const auto look_at = [&](std::size_t first, std::size_t end) {
        float most = 0.0F;
        for (std::size_t i = first; i < end; ++i) most = std::max(most, agents[i].moves ? wishes[i].most_speed : 0.0F);
        raise(fastest, most);
      };
      CrowdCells::sort(agents, executor, jobs, look_at,
                       [this](const Body& agent, std::size_t place) { write_body(agent, place, columns_); });
      return fastest.load();
    }

   private:
    static void raise(std::atomic<float>& most, float value) {
      float seen = most.load(std::memory_order_relaxed);
      while (value > seen && !most.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
      }
    }

    BodyColumns columns_;
  };

  Steering() = default;
  Steering(std::size_t agents, const Ground& ground);

  /// Moves the bodies that move by one step of `seconds`, above 0: writes their new positions and velocities into
  /// `bodies`. There is one wish an agent, and `bodies[i].agent` is i. `jobs`, 1 or more, run at once on `executor`.
  /// Allocates nothing.
  void step(std::span<Body> bodies, std::span<const Wish> wishes, float seconds, Executor& executor, int jobs);

 private:
  Ground ground_;
  float reach_ = 1.0F;
  float longest_step_ = 0.0F;  // metres that no agent exceeds in one step
  Searched agents_;
  std::shared_ptr<const ObstacleMap> obstacles_;  // never changes, so that copies share it; null: there are none
};

}  // namespace throng::app
