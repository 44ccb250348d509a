#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/population.h"
#include "engine/anim/agent/system_options.h"
#include "engine/anim/run/pu_threads.h"
#include "engine/anim/run/scheduler.h"

namespace throng::anim {

/// The scheduler of a system, and the options that it was made by. Its local stores hold what every graph asks of them.
/// When the graphs grow, automatic stores grow too, and stores of a fixed size refuse the change.
class FittedScheduler {
 public:
  /// Takes all options, and converts the population to them. Errors: the number of PUs is out of range, or a local
  /// store of a fixed size is too small; then nothing has changed.
  Status configure(Population& population, const SystemOptions& options);
  /// Fits the stores to a character that was added. Errors: a store of a fixed size is too small; then nothing has
  /// changed but the contexts.
  Status take_character(const Population& population, std::uint32_t character);
  const SystemOptions& options() const { return options_; }
  void record_trace(Tracing tracing, std::uint32_t agents);

  /// Returns [character] the context that PUs read. refresh_contexts() makes them anew when a mask, a selection or a
  /// character was added.
  std::span<const UpdateContext> contexts() const { return contexts_; }
  void refresh_contexts(const Population& population);
  /// Sets [agent] where PUs write the hashes of palettes. They hash nothing if it is empty.
  void set_hashes(std::span<std::uint64_t> hashes);
  /// Sets [agent] where PUs write lists of joints.
  void set_joints(std::span<const PaletteDestination> joints_to);

  /// Changes the graph of an agent, and fits the stores to the changed graph.
  template <typename Change>
  Status settle(const Population& population, std::uint32_t agent, Change&& change_graph) {
    // The needs of before say nothing: a failed change may have left that graph, and it may fit no store.
    Status changed = change_graph();
    return changed ? fit(population, agent) : changed;
  }
  /// Updates the channels of an agent, or the channel at a place. If there is no room for their fades, the agent is
  /// shown without them.
  Status update_channels(Population& population, std::uint32_t agent);
  Status update_channel(Population& population, std::uint32_t agent, std::size_t place);
  /// Updates the channels of a character's agents that are due by the clock, posed or not.
  void update_due_channels(Population& population, std::uint32_t character);
  /// Returns what all graphs ask of the stores.
  LocalStoreDemand demand(const Population& population) const;
  Status fit(const Population& population, const LocalStoreDemand& needs);
  /// Returns the cost of an agent of this character, in steps of cost_step.
  std::uint16_t predicted_cost(const PoseProgram& program, std::uint32_t character, int level) const {
    return cost_in_steps(options_.cost.of_agent(program.parts, contexts_[character].packets(level)));
  }
  /// Makes room for all agents, so that an update allocates nothing, and chooses how palettes are written.
  void reserve(const Population& population);

  Scheduler& scheduler() { return *scheduler_; }
  const Scheduler& scheduler() const { return *scheduler_; }
  /// Returns how many schedulers were made. Another number means other options or other stores.
  std::uint64_t version() const { return version_; }
  /// Returns why PUs cannot run in this process, in one sentence; null if they can.
  const char* fault() const;
  Executor& executor() const { return threads_ == nullptr ? *options_.executor : *threads_; }

 private:
  template <typename Update>
  Status update_parts(Population& population, std::uint32_t agent, Update&& update);
  LocalStoreDemand demand(const Population& population, const SystemOptions& options) const;
  Status fit(const Population& population, std::uint32_t agent);
  void make_scheduler(const Population& population, const LocalStorePlan& plan, std::size_t store_bytes);
  StorePolicy store_policy(const Population& population) const;

  SystemOptions options_;
  std::vector<UpdateContext> contexts_;  // [character]
  std::unique_ptr<Scheduler> scheduler_;
  std::uint64_t version_ = 0;
  std::unique_ptr<PuThreads> threads_;  // null where a host's executor runs the PUs
};

}  // namespace throng::anim
