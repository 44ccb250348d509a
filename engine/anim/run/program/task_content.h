#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// The agents that a PU worked for. Agents of a tile are in no particular order, and need not follow each other.
struct TaskContent {
  static constexpr std::uint8_t several_levels = 255;

  std::uint32_t first_agent = 0;  ///< the lowest of their numbers
  std::uint32_t last_agent = 0;   ///< the highest
  std::uint16_t agents = 0;       ///< their number; 0: work for no agent, or for shared graphs
  std::uint8_t bone_level = 0;    ///< the level of all, or several_levels

  friend bool operator==(const TaskContent&, const TaskContent&) = default;
};

/// The agents of several tasks in a row. A task for the same agents as the task before adds none.
class JoinedContent {
 public:
  void add(const TaskContent& task) {
    if (task.agents == 0 || task == newest_) return;
    newest_ = task;
    if (all_.agents == 0) {
      all_ = task;
      return;
    }
    constexpr int most = std::numeric_limits<std::uint16_t>::max();
    all_.first_agent = std::min(all_.first_agent, task.first_agent);
    all_.last_agent = std::max(all_.last_agent, task.last_agent);
    all_.agents = static_cast<std::uint16_t>(std::min(all_.agents + task.agents, most));
    if (all_.bone_level != task.bone_level) all_.bone_level = TaskContent::several_levels;
  }
  const TaskContent& all() const { return all_; }

 private:
  TaskContent all_, newest_;
};

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
