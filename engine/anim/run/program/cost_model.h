#pragma once

#include <cstdint>

namespace throng::anim {

/// The parts of a program that cost time.
struct ProgramParts {
  std::uint8_t players = 0;           ///< entities that read a stream
  std::uint8_t blenders = 0;          ///< other entities that make packets: blenders, mixers, layers, noise
  std::uint16_t whole_pose_work = 0;  ///< EntityKind::whole_pose_work of the entities that need the whole pose

  friend bool operator==(const ProgramParts&, const ProgramParts&) = default;
};

/// Paper 3.2: "never treat tasks as equal units". The model predicts the time of a task, in nanoseconds of one PU, from
/// bones (as packets of 16), sources and post processes. It orders tasks and says where tiles are cut. Poses do not
/// depend on it, so a coarse model only costs time. `throng_cost_sweep` (tests/benchmark) measured the coefficients on
/// one core with AVX-512, within 12% on average; only their proportion counts.
struct CostModel {
  double tile = 105;           ///< once a strip of a tile, however few its characters
  double tile_packet = 255;    ///< hierarchy and palettes of 16 bones across a strip, however few its characters
  double agent = 95;           ///< copies, clocks
  double player_packet = 23;   ///< 16 bones of a player
  double blender_packet = 27;  ///< 16 bones of an entity that combines or changes them
  double post_process = 165;   ///< a whole pose held, and a gaze
  double least_task = 10'000;  ///< another PU is not worth waking for less

  double of_agent(const ProgramParts& parts, int packets) const {
    const double packet = parts.players * player_packet + parts.blenders * blender_packet;
    return agent + packets * packet + parts.whole_pose_work * post_process;
  }
  /// Returns the overhead of each strip.
  double of_tile(int packets) const { return tile + packets * tile_packet; }

  friend bool operator==(const CostModel&, const CostModel&) = default;
};

/// The nanoseconds of one step of a cost. The work of each agent keeps its cost in steps, in 2 bytes.
inline constexpr double cost_step = 16;

constexpr std::uint16_t cost_in_steps(double nanoseconds) {
  constexpr double most = 65535;
  const double steps = nanoseconds / cost_step;
  return static_cast<std::uint16_t>(steps < 1 ? 1 : steps > most ? most : steps);
}

}  // namespace throng::anim
