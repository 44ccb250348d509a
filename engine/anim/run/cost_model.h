#pragma once

#include <cstddef>
#include <cstdint>

namespace throng::anim {

/// What of a program costs time.
struct ProgramParts {
  std::uint8_t players = 0;         ///< read a stream
  std::uint8_t blenders = 0;        ///< whatever else makes packets: blenders, mixers, layers, noise
  std::uint8_t post_processes = 0;  ///< need the whole pose: reach, gaze, feet, rag-dolls
};

/// Paper 3.2: "never treat tasks as equal units": what a task takes, nanoseconds of one PU, from bones (as packets of
/// 16), sources and post processes. Orders tasks and says where tiles are cut; poses do not depend on it, so a coarse
/// one only costs time. Measured by `throng bench --sweep cost` for a 62-bone character on one core with AVX-512; what
/// counts is their proportion, which other machines share.
struct CostModel {
  double tile = 220;           ///< handing a tile out, and its scratch
  double tile_packet = 620;    ///< hierarchy of 16 bones across a tile, however few characters it has
  double agent = 60;           ///< copies, clocks
  double player_packet = 22;   ///< 16 bones of a player
  double blender_packet = 12;  ///< of what combines or changes them
  double palette_packet = 20;  ///< their palette matrices
  double post_process = 700;   ///< a whole pose held, and one change to it
  double least_task = 4'000;   ///< below which waking another PU does not pay

  double of_agent(const ProgramParts& parts, int packets) const {
    const double packet = parts.players * player_packet + parts.blenders * blender_packet + palette_packet;
    return agent + packets * packet + parts.post_processes * post_process;
  }
  double of_tile(int packets) const { return tile + packets * tile_packet; }

  friend bool operator==(const CostModel&, const CostModel&) = default;
};

/// Costs are kept with the work of each agent in steps of so many nanoseconds, 2 bytes each.
inline constexpr double cost_step = 16;

constexpr std::uint16_t cost_in_steps(double nanoseconds) {
  constexpr double most = 65535;
  const double steps = nanoseconds / cost_step;
  return static_cast<std::uint16_t>(steps < 1 ? 1 : steps > most ? most : steps);
}

}  // namespace throng::anim
