#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace throng::app {

/// Holds columns of bodies for steering. Each number has an array of its own, so that vectors are loaded from it:
///
///     x        [body 0][body 1] ... [body count-1][padding: most_lanes]
///     z        the same; then the others
///
/// A vector that begins at a body may reach into the padding.
struct BodyColumns {
  static constexpr std::size_t most_lanes = 64;  ///< floats in a vector of any target

  std::vector<float> x, z, velocity_x, velocity_z, radius;  ///< read by the search
  std::vector<float> share_of_gap;     ///< that others may take of the gap to it: half, or all of it if it stands
  std::vector<std::uint32_t> company;  ///< the agent that it keeps beside

  void set_aside(std::size_t bodies);
};

/// The bodies from `first` up to before `end`, one after the other in the columns.
struct BodyRun {
  std::uint32_t first = 0, end = 0;
};

/// Finds the bodies that matter to a walker: bodies in sight that are close, or that it would pass too close to. The
/// radius of another body is r; lengths are metres and speeds metres a second.
struct NearBodiesJob {
  const BodyColumns* columns = nullptr;
  std::span<const BodyRun> runs = {};  ///< searched in this order
  glm::vec2 position{0.0F};
  glm::vec2 velocity{0.0F};  ///< that it would like to have
  float sight = 0.0F;        ///< it sees as far as sight + sight_per_radius * r, from middle to middle
  float sight_per_radius = 0.0F;
  float passing_scale = 1.0F;  ///< it passes at passing_scale * (passing_offset + r)
  float passing_offset = 0.0F;
  float close_offset = 0.0F;  ///< a body is close within close_offset + r + close_reach
  float close_reach = 0.0F;
  float horizon = 0.0F;  ///< seconds that it looks ahead
};

/// Says where a search goes on.
struct NearBodiesCursor {
  std::size_t run = 0;
  std::uint32_t passed = 0;  ///< bodies of that run
};

/// The bodies that a search found, by their places in the columns, in the order of the runs.
struct NearBodies {
  static constexpr std::size_t most = 64;  ///< in one go

  std::array<std::uint32_t, most + BodyColumns::most_lanes> places;
  std::size_t count = 0;
};

bool is_valid(const NearBodiesJob& job);

/// Searches from the cursor on until all runs are done, or `found` has no room for another vector. Returns whether all
/// is done. A body just out of reach may be found too, within rounding; the caller that reads the places decides.
bool find_near_bodies(const NearBodiesJob& job, NearBodiesCursor& cursor, NearBodies& found);

}  // namespace throng::app
