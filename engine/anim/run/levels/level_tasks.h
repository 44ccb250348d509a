#pragma once

#include <span>

#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/task_content.h"
#include "engine/anim/run/program/tile.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/strip_palettes.h"
#include "engine/anim/run/store/task_queue.h"

namespace throng::anim {

/// One entity to be updated in the `levels` schedule.
struct EntityUpdate {
  const AgentWork* agent = nullptr;  ///< the agent that owns it
  std::uint16_t cost = 1;            ///< predicted, in steps of cost_step
  std::uint8_t step = 0;             ///< its step of the program

  const PoseProgram& program() const { return *agent->program; }
  Handle entity() const { return agent->entities[step]; }
  std::size_t source_count() const { return program().steps[step].source_count; }
  Handle source(std::size_t index) const { return agent->entities[program().steps[step].sources[index]]; }
};
static_assert(sizeof(EntityUpdate) == 2 * sizeof(void*));

/// One priority of the paper's schedule (2.2.3, 2.2.5): entities in any order, each copied in whole, updated, and
/// copied back whole. Its sources come along, header and transforms, and are not written back.
///
///     fetch buffer   [the entity | source 0, without its private part | source 1 | ...]
class EntityTasks {
 public:
  EntityTasks(std::span<const UpdateContext> contexts, std::span<const EntityUpdate> updates, TaskQueue::Taker queue,
              const LocalStore& store)
      : contexts_(contexts), updates_(updates), queue_(queue), store_(&store) {}

  static constexpr std::size_t scratch_bytes = most_prepared_bytes;

  std::optional<int> next() { return queue_.take(); }
  void fetch(int task, int buffer, CopyEngine& engine) const;
  int copy_points(int task) const { return context(task).packets(update(task).agent->level); }
  void compute(int task, int buffer, CopyEngine& engine);
  void write_back(int task, int buffer, CopyEngine& engine) const;

  TaskContent content(int task) const { return content_of(update(task).agent->agent, update(task).agent->level); }

  std::uint32_t entities_done() const { return entities_done_; }

 private:
  const EntityUpdate& update(int task) const { return updates_[static_cast<std::size_t>(task)]; }
  const UpdateContext& context(int task) const { return contexts_[update(task).agent->skeleton]; }

  std::span<const UpdateContext> contexts_;
  std::span<const EntityUpdate> updates_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  std::uint32_t entities_done_ = 0;
};

/// The last level makes palettes of finished states, by way of model space. It runs across characters, so it streams
/// one packet of each character of a tile at a time through the fetch buffers.
class PaletteTasks {
 public:
  struct Task {
    int tile;
    int packet;
  };

  PaletteTasks(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, std::span<const Tile> tiles,
               TaskQueue::Taker queue, const LocalStore& store, const PaletteStores& stores)
      : contexts_(contexts), work_(work), tiles_(tiles), queue_(queue), store_(&store), stores_(stores) {}

  static std::size_t fetch_bytes(const UpdateContext& context, int width);
  static std::size_t scratch_bytes(const UpdateContext& context, int width);

  std::optional<Task> next();
  void fetch(const Task& task, int buffer, CopyEngine& engine) const;
  static int copy_points(const Task&) { return 1; }
  void compute(const Task& task, int buffer, CopyEngine& engine);
  void write_back(const Task&, int, CopyEngine&) const {}

  TaskContent content(const Task& task) const { return content_of(agents(task)); }

  std::uint32_t tiles_done() const { return tiles_done_; }
  std::uint32_t agents_done() const { return agents_done_; }

 private:
  std::span<const AgentWork> agents(const Task& task) const;
  const UpdateContext& context(const Task& task) const { return contexts_[agents(task).front().skeleton]; }
  void begin_tile(const UpdateContext& context, std::span<const AgentWork> tile);

  std::span<const UpdateContext> contexts_;
  std::span<const AgentWork> work_;
  std::span<const Tile> tiles_;
  TaskQueue::Taker queue_;
  const LocalStore* store_;
  PaletteStores stores_;
  StripPalettes palettes_;
  std::optional<Task> last_;
  std::uint32_t tiles_done_ = 0;
  std::uint32_t agents_done_ = 0;
};

}  // namespace throng::anim
