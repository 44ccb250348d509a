#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

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

}  // namespace throng::anim
