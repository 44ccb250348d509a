#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/task_content.h"

namespace throng::anim {

/// The most strips of one tile. Each is as wide as kernels work side by side.
inline constexpr int most_strips = 2;
inline constexpr int most_characters = most_strips * widest_strip;

/// Agents of a tile that follow each other and run one program.
struct AgentRun {
  const PoseProgram* program = nullptr;
  std::uint32_t first = 0;  ///< number in the tile
  std::uint32_t count = 0;

  std::uint32_t end() const { return first + count; }
};

/// The agents that a PU is handed together, of one skeleton and bone level, all held or all streaming. They come into
/// its store together, and are posed strip by strip.
struct Tile {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t width = widest_strip;  ///< characters of a strip
  float cost = 0;                      ///< predicted, nanoseconds
  std::uint32_t first_run = 0;         ///< place in CutWork::runs
  std::uint32_t run_count = 0;         ///< no run can be made longer
  StoreNeeds needs = {};               ///< the widest of its agents

  std::uint32_t strips() const { return (count + width - 1) / width; }
};

/// The work of an update in tiles, and the runs in these.
struct CutWork {
  std::span<const Tile> tiles;
  std::span<const AgentRun> runs;

  std::span<const AgentRun> runs_of(const Tile& tile) const { return runs.subspan(tile.first_run, tile.run_count); }
};

/// Calls visit(run) for each run in the `count` agents of a tile from `first` on, and counts from that agent.
template <typename Visit>
void for_each_run(std::span<const AgentRun> runs, std::size_t first, std::size_t count, Visit&& visit) {
  for (const AgentRun& run : runs) {
    const auto begin = static_cast<std::uint32_t>(std::max<std::size_t>(run.first, first));
    const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(run.end(), first + count));
    if (begin < end) visit(AgentRun{run.program, begin - static_cast<std::uint32_t>(first), end - begin});
  }
}

inline TaskContent content_of(std::uint32_t agent, std::uint8_t bone_level) {
  if ((agent & shared_owner) != 0) return {};
  return {.first_agent = agent, .last_agent = agent, .agents = 1, .bone_level = bone_level};
}

inline TaskContent content_of(std::span<const AgentWork> tile) {
  std::uint32_t first = tile.front().agent;
  std::uint32_t last = first;
  std::size_t next = 1;
  while (next < tile.size() && tile[next].agent > last) last = tile[next++].agent;  // nearly always all of them
  for (const AgentWork& work : tile.subspan(next)) {
    first = std::min(first, work.agent);
    last = std::max(last, work.agent);
  }
  return {.first_agent = first,
          .last_agent = last,
          .agents = static_cast<std::uint16_t>(tile.size()),
          .bone_level = tile.front().level};
}

}  // namespace throng::anim
