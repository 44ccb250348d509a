#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "app/people/crowd/steering/near_bodies.h"

namespace throng::app {

/// Two agents never come nearer than this share of their radii summed, if they were not when they began.
inline constexpr float least_share_of_radii = 0.82F;
inline constexpr float steering_horizon = 2.5F;  ///< seconds that an agent looks ahead

/// Holds what all walkers share in a step. Lengths are metres.
struct StepRules {
  float seconds = 0.0F;
  float spacing = 1.0F;     ///< CharacterRoles::spacing
  float most_speed = 0.0F;  ///< metres a second that no agent exceeds
  float sight = 0.0F;       ///< as far as an agent looks, from middle to middle
  float closing = 0.0F;     ///< the most by which two come nearer in a step
};

/// Says how far a walker keeps from bodies of one kind. The walker has the radius s, the other body the radius r.
///
///     it sees        sight + sight_per_radius * r
///     it passes at   passing_scale * (passing_per_radius * s + r), if it can
///     it stays at    least_share_of_radii * (s + r), at least
struct KeptDistances {
  float sight_per_radius;
  float passing_scale, passing_per_radius;
  float least_share_of_radii;
  bool are_agents;  ///< these bodies are agents; a walker is not polite to its company
};
inline constexpr KeptDistances kept_from_agents{.sight_per_radius = 0.0F,
                                                .passing_scale = 1.5F,
                                                .passing_per_radius = 1.0F,
                                                .least_share_of_radii = least_share_of_radii,
                                                .are_agents = true};
inline constexpr KeptDistances kept_from_obstacles{.sight_per_radius = 1.0F,
                                                   .passing_scale = 1.0F,
                                                   .passing_per_radius = 1.8F,
                                                   .least_share_of_radii = 1.0F,
                                                   .are_agents = false};

/// Walkers that take a step side by side, and what each has seen so far. Each number has a row of lanes:
///
///     x           [walker 0][walker 1] ... [walker 15]
///     z, ...      the same
///     soft        16 lanes of limit 0, 16 lanes of limit 1, ...
///
/// A limit is a half-plane of velocities: velocity . towards is at most `soft` to be polite and `hard` to stay apart.
/// Lanes without a limit hold infinities there.
struct StepStrip {
  static constexpr std::size_t lanes = 16;
  static constexpr std::uint32_t most_limits = 32;  ///< no more discs fit within a step's reach
  static constexpr std::uint32_t nowhere = UINT32_MAX;
  using Floats = std::array<float, lanes>;
  using Numbers = std::array<std::uint32_t, lanes>;

  std::size_t count = 0;  ///< of walkers; the other lanes hold zeros
  alignas(64) Floats x{}, z{}, velocity_x{}, velocity_z{}, radius{}, wish_x{}, wish_z{}, most_speed{};
  alignas(64) Numbers company{};  ///< the agent that the walker keeps beside, as in BodyColumns
  alignas(64) Numbers place{};    ///< of the walker among the agents

  alignas(64) Floats turn_x{}, turn_z{};  ///< metres a second, away from others
  alignas(64) Numbers limit_count{};      ///< most_limits + 1: more bodies are close than limits fit
  std::uint32_t limit_rows = 0;           ///< of the four below: the largest count
  alignas(64) std::array<Floats, most_limits> towards_x, towards_z, soft, hard;
};

/// The places of the bodies that matter to the walker of each lane, in the order in which it sees them.
struct FoundByLane {
  alignas(64) std::array<StepStrip::Numbers, NearBodies::most> places;  ///< [k][lane]; beyond the count: anything
  alignas(64) StepStrip::Numbers count{};
};

/// Lets the walkers of a strip see bodies that were found for them.
struct SeeJob {
  const BodyColumns* bodies = nullptr;
  const FoundByLane* found = nullptr;
  KeptDistances keeps = kept_from_agents;
  StepRules rules;
};

bool is_valid(const SeeJob& job, const StepStrip& strip);

/// Adds to the walkers' turns and limits. Each lane has the bits of the same sums in a loop.
void see(const SeeJob& job, StepStrip& strip);

/// Moves each walker by a step, which follows from all bodies that it saw: replaces velocity and place.
void take_step(const StepRules& rules, StepStrip& strip);

}  // namespace throng::app
