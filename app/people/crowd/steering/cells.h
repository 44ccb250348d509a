#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/steering/ground_grid.h"
#include "app/people/crowd/steering/near_bodies.h"
#include "engine/base/tiles.h"

namespace throng::app {

/// An agent as the others see it when a step begins.
struct Body {
  glm::vec2 position{0.0F};  ///< x, z in metres
  glm::vec2 velocity{0.0F};  ///< metres a second
  float radius = 0.0F;       ///< metres
  std::uint32_t agent = 0;
  std::uint32_t company = 0;  ///< the agent that it keeps beside; its own number, if it is alone
  bool moves = false;         ///< false: it stands still during the step
};

/// Writes a body into the columns.
inline void write_body(const Body& body, std::size_t place, BodyColumns& columns) {
  columns.x[place] = body.position.x;
  columns.z[place] = body.position.y;
  columns.velocity_x[place] = body.velocity.x;
  columns.velocity_z[place] = body.velocity.y;
  columns.radius[place] = body.radius;
  columns.share_of_gap[place] = body.moves ? 0.5F : 1.0F;
  columns.company[place] = body.company;
}

/// A run of bodies for each row of cells, the lowest row first.
struct CellRuns {
  static constexpr std::size_t most = 8;  ///< a cell is at least half as long as an agent looks

  std::array<BodyRun, most> all;
  std::size_t count = 0;

  std::span<const BodyRun> runs() const& { return {all.data(), count}; }
  std::span<const BodyRun> runs() && = delete;  ///< a loop over them would outlive them
};

/// A uniform grid over the ground. It sorts bodies by cell, and by agent within a cell, so that the bodies near a point
/// are a few runs in memory and always come in the same order. Bodies beyond the edge belong to the cells along it.
class CrowdCells {
 public:
  /// Sets memory aside for `bodies` on the ground from `lowest` to `highest`. An agent looks as far as `reach`, in
  /// metres.
  void set_aside(std::size_t bodies, glm::vec2 lowest, glm::vec2 highest, float reach);

  /// Sorts as many bodies as were set aside, by counting. Allocates nothing.
  void sort(std::span<const Body> bodies);
  /// Sorts in `jobs` jobs. Calls `look_at(first, end)` for tiles of `bodies`, and `visit(const Body&, std::size_t
  /// place)` for each with its place in bodies().
  template <typename LookAt, typename Visit>
  void sort(std::span<const Body> bodies, Executor& executor, int jobs, const LookAt& look_at, const Visit& visit) {
    assert(bodies.size() == sorted_.size());
    visit_tiles(bodies.size(), executor, jobs, [&](std::size_t first, std::size_t end) {
      for (std::size_t body = first; body < end; ++body) {
        cells_[body] = static_cast<std::uint32_t>(grid_.cell(bodies[body].position));
      }
      look_at(first, end);
    });
    find_order();
    visit_in_tiles(bodies.size(), executor, jobs, [&](std::size_t place) {
      sorted_[place] = bodies[order_[place]];
      visit(sorted_[place], place);
    });
  }

  /// Returns all bodies, in the order of cells.
  std::span<const Body> bodies() const { return sorted_; }

  /// Returns the runs of bodies() that hold every body within reach of `position`, and some beyond it.
  CellRuns runs_near(glm::vec2 position) const {
    const std::size_t left = grid_.column(position.x - reach_), right = grid_.column(position.x + reach_);
    const std::size_t top = grid_.row(position.y - reach_), bottom = grid_.row(position.y + reach_);
    CellRuns runs;
    for (std::size_t at = top; at <= bottom; ++at) {
      const BodyRun run{first_[at * grid_.columns + left], first_[at * grid_.columns + right + 1]};
      if (run.first != run.end) runs.all[runs.count++] = run;
    }
    return runs;
  }

  /// Calls `visit(const Body&)` for every body within reach of `position`, and for some beyond it.
  template <typename Visit>
  void visit_near(glm::vec2 position, const Visit& visit) const {
    const CellRuns found = runs_near(position);
    for (const BodyRun& run : found.runs()) {
      for (std::uint32_t body = run.first; body < run.end; ++body) visit(sorted_[body]);
    }
  }

 private:
  void find_order();

  GroundGrid grid_;
  float reach_ = 0.0F;
  std::vector<std::uint32_t> first_;  // [cell] where it begins in sorted_; one more element marks the end
  std::vector<std::uint32_t> cells_;  // [body]
  std::vector<std::uint32_t> order_;  // [place in sorted_] the body
  std::vector<Body> sorted_;
};

}  // namespace throng::app
