#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/channel.h"
#include "engine/anim/agent/post_process.h"
#include "engine/anim/base/result.h"
#include "engine/anim/run/program/program_table.h"

namespace throng::anim {

/// How a channel lies over those before it.
struct LayerSettings {
  float weight = 1.0F;              ///< 0 to 1
  int mask = EaseBlender::no_mask;  ///< what `AnimationSystem::add_mask` returned
};

/// Paper 2.1.2: the agents of one skeleton. Each has channels, the later laid over the earlier, and post processes on
/// top; what these make is one graph of entities, compiled whenever it changes:
///
///     channel 0 ──┐
///     channel 1 ──┴ blender ──┐
///     channel 2 ──────────────┴ blender ── post process 0 ── post process 1 ── pose
class Agents {
 public:
  /// `owners`: shared_owner for graphs whose entities agents read (pose_program.h), which are "agents" here too.
  /// `programs`: where graphs that look alike find the same program; outlives this.
  Agents(EntityPools& pools, ProgramTable& programs, std::uint32_t owners = 0)
      : pools_(&pools), programs_(&programs), owners_(owners) {}

  std::uint32_t count() const { return static_cast<std::uint32_t>(agents_.size()); }
  void resize(std::uint32_t count);

  const PoseGraph& graph(std::uint32_t agent) const { return graphs_[agent]; }
  const PoseProgram& program(std::uint32_t agent) const { return *graphs_[agent].program; }
  Ticks next_update(std::uint32_t agent) const { return next_updates_[agent]; }

  std::size_t channel_count(std::uint32_t agent) const { return agents_[agent].layers.size(); }
  Channel& channel(std::uint32_t agent, std::size_t index) const { return *agents_[agent].layers[index].channel; }

  /// On error the channel is there until remove_channel(); the agent goes on with the graph that it had.
  Status add_channel(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<Channel> channel,
                     const LayerSettings& settings);
  void remove_channel(const EntityBuilder& build, std::uint32_t agent, std::size_t index);
  Status add_post_process(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<PostProcess> process);
  /// All but the first `kept`.
  void remove_post_processes(const EntityBuilder& build, std::uint32_t agent, std::size_t kept = 0);
  /// The last one, without its entities, to be given to another agent.
  std::unique_ptr<PostProcess> take_last_post_process(const EntityBuilder& build, std::uint32_t agent);
  std::size_t post_process_count(std::uint32_t agent) const { return agents_[agent].processes.size(); }
  PostProcess& post_process(std::uint32_t agent, std::size_t index) const { return *agents_[agent].processes[index]; }
  /// Updates one process alone.
  Status update_post_process(const EntityBuilder& build, std::uint32_t agent, std::size_t index);
  void set_weight(std::uint32_t agent, std::size_t channel, float weight);

  /// Updates every channel and post process and rebuilds the graph if one of them changed. On error (a channel made a
  /// graph with a cycle) the agent goes on with the graph that it had if all its entities still live, else it has
  /// none.
  Status update(const EntityBuilder& build, std::uint32_t agent);
  /// After a channel was changed from outside.
  Status rebuild(const EntityBuilder& build, std::uint32_t agent);
  /// After layouts changed.
  void recompile();

  /// Moves every player of an agent to the pool of the builder's stream.
  void restream(const EntityBuilder& build, std::uint32_t agent);

  /// Keyframe players find their keys anew at the next update: the streams are others.
  void restart_keyframes();
  /// Entities that keep transforms keep those of the same bones: `places` has the new index of each.
  void reorder_kept_transforms(std::span<const int> places);

  /// The most that any program asks of the local store.
  StoreNeeds largest_needs() const;

  Agents clone() const;
  std::size_t bytes() const;

 private:
  struct Layer {
    std::unique_ptr<Channel> channel;
    LayerSettings settings;
    Handle blender;  // over all layers before; invalid for the first
  };
  struct Agent {
    std::vector<Layer> layers;
    std::vector<std::unique_ptr<PostProcess>> processes;
  };

  Handle lay(const EntityBuilder& build, Layer& layer, Handle below) const;
  void find_next_update(std::uint32_t agent);
  void visit_handles(Agent& agent, const std::function<void(Handle&)>& visit) const;
  void destroy(Agent& agent) const;
  bool all_alive(const PoseGraph& graph) const;

  EntityPools* pools_;
  ProgramTable* programs_;
  std::uint32_t owners_;
  std::vector<Agent> agents_;
  std::vector<PoseGraph> graphs_;  // [agent], beside each other: the part that every frame reads
  std::vector<Ticks> next_updates_;
};

}  // namespace throng::anim
