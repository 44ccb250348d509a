#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "throng/ids.h"

#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/agent/post_process.h"
#include "engine/anim/base/type_tag.h"
#include "engine/anim/run/program/program_table.h"
#include "engine/base/compiler.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The weight and the mask with which a channel lies over the channels before it.
struct LayerSettings {
  float weight = 1.0F;              ///< 0 to 1
  int mask = EaseBlender::no_mask;  ///< the number that `Characters::add_mask` returned
};

/// A channel or post process of an agent.
template <typename Part>
struct OwnedPart {
  std::unique_ptr<Part> part;
  TypeTag type = 0;      ///< of the type as which it was given
  std::uint32_t id = 0;  ///< the number of a ChannelId or ProcessId
};
using OwnedChannel = OwnedPart<Channel>;
using OwnedProcess = OwnedPart<PostProcess>;

/// The graphs of the agents of one character. Each agent has channels, which lie one over the other in their order, and
/// post processes on top. Their entities form one graph, which is compiled whenever it changes:
///
///     channel 0 ──┐
///     channel 1 ──┴ blender ──┐
///     channel 2 ──────────────┴ blender ── post process 0 ── post process 1 ── pose
class AgentGraphs {
 public:
  /// `owners` is shared_owner for graphs that agents read (pose_program.h); each counts as an agent here.
  /// `programs` gives graphs of one shape the same program, and outlives this object.
  AgentGraphs(EntityPools& pools, ProgramTable& programs, std::uint32_t owners = 0)
      : pools_(&pools), programs_(&programs), owners_(owners) {}

  /// Returns a number above the numbers of all agents. Removed agents have empty graphs.
  std::uint32_t count() const { return static_cast<std::uint32_t>(agents_.size()); }
  std::uint32_t alive_count() const { return static_cast<std::uint32_t>(agents_.size() - free_.size()); }
  /// Adds an agent that plays nothing, and returns its number. Numbers and memory of removed agents are used again.
  std::uint32_t add();
  void remove(std::uint32_t agent);
  /// Makes room for so many more agents.
  void make_room(std::uint32_t agents);
  /// Returns a channel that plays nothing: a removed agent's if there is any.
  std::unique_ptr<CrossFadeChannel> take_cross_fade_channel();

  const PoseGraph& graph(std::uint32_t agent) const { return graphs_[agent]; }
  Ticks next_update(std::uint32_t agent) const { return next_updates_[agent]; }

  enum class Fades : unsigned char { go_on, are_cut };

  // Channels and post processes of an agent have places, from the bottom up, which change when a part below is removed,
  // and ids, which do not.
  std::size_t channel_count(std::uint32_t agent) const { return agents_[agent].layers.size(); }
  const OwnedChannel& channel(std::uint32_t agent, std::size_t place) const { return agents_[agent].layers[place].own; }
  /// Returns the place of a channel; nothing if the agent has none of this id.
  std::optional<std::size_t> place(std::uint32_t agent, ChannelId channel) const;
  std::size_t post_process_count(std::uint32_t agent) const { return agents_[agent].processes.size(); }
  const OwnedProcess& post_process(std::uint32_t agent, std::size_t place) const {
    return agents_[agent].processes[place];
  }
  std::optional<std::size_t> place(std::uint32_t agent, ProcessId process) const;

  /// Adds a channel on top. Errors: those of compile_graph; then the channel stays until remove_channel(), and the
  /// agent goes on with the graph that it had.
  Status add_channel(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<Channel> channel, TypeTag type,
                     const LayerSettings& settings);
  void remove_channel(const EntityBuilder& build, std::uint32_t agent, std::size_t place);
  Status add_post_process(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<PostProcess> process,
                          TypeTag type);
  /// Takes a process without its entities, so that another agent can have it.
  std::unique_ptr<PostProcess> take_post_process(const EntityBuilder& build, std::uint32_t agent, std::size_t place);
  /// Moves the weight of a channel evenly from where it is, so that it arrives after `fade`.
  void set_weight(const EntityBuilder& build, std::uint32_t agent, std::size_t channel, float weight, Ticks fade);

  /// Updates every channel and post process. Returns whether it is done: if not, the graph must be rebuilt.
  bool update(const EntityBuilder& build, std::uint32_t agent);
  enum class Entities : unsigned char { may_change, stay };
  /// Does update() for one part of the agent alone. Where entities stay, a part that needs others is not updated, and
  /// threads call it at once, each for another agent.
  template <typename Part>
  bool update_alone(const EntityBuilder& build, std::uint32_t agent, Part& part, Entities entities) {
    if (entities == Entities::stay && graphs_[agent].empty()) return false;
    const bool keeps = entities == Entities::stay ? part.update_in_place(build) : !part.update(build);
    if (keeps) find_next_update(agent);
    return keeps && !graphs_[agent].empty();
  }
  /// Rebuilds the graph after a part has changed; or, where that graph has no room, cuts what channels fade by
  /// themselves. Errors: the parts made a graph with a cycle; then the agent keeps its graph if all entities of it are
  /// still alive, or else has none.
  Status rebuild(const EntityBuilder& build, std::uint32_t agent, Fades fades = Fades::go_on);
  /// Compiles all graphs anew. Call it when layouts of entities have changed.
  void recompile();

  /// Moves every player of an agent to the pool of the builder's stream.
  void restream(const EntityBuilder& build, std::uint32_t agent);

  /// Makes keyframe players find their keys anew at the next update, because their streams have changed.
  void restart_keyframes();
  /// Moves entities' values of each bone to its new index; `places` has the index for each bone.
  void reorder_bones(std::span<const int> places);

  /// Returns the most that any program asks of the local store.
  StoreNeeds largest_needs() const;

  AgentGraphs clone() const;
  std::size_t bytes() const;

 private:
  friend void prefetch_agent(const AgentGraphs& graphs, std::uint32_t agent);
  friend Handle newest_player(const AgentGraphs& graphs, std::uint32_t agent);
  struct Layer {
    OwnedChannel own;
    LayerSettings settings;
    Handle blender;             // over all layers before; invalid for the first
    float weight_per_second{};  // while the weight fades
    Ticks faded_at = never;     // by the clock; never: the weight does not fade
  };
  struct Agent {
    std::vector<Layer> layers;
    std::vector<OwnedProcess> processes;
    std::uint32_t channels_given = 0;
    std::uint32_t processes_given = 0;
  };

  Handle lay(const EntityBuilder& build, Layer& layer, Handle below) const;
  static void write_weight(const EntityBuilder& build, const Layer& layer);
  static void end_fade(const EntityBuilder& build, Layer& layer);
  void rebuild_with_less(const EntityBuilder& build, std::uint32_t agent);
  void find_next_update(std::uint32_t agent);
  void find_newest_player(std::uint32_t agent);
  void visit_handles(Agent& agent, const std::function<void(Handle&)>& visit) const;
  void destroy(Agent& agent);
  bool all_alive(const PoseGraph& graph) const;

  EntityPools* pools_;
  ProgramTable* programs_;
  std::uint32_t owners_;
  std::vector<Agent> agents_;
  std::vector<PoseGraph> graphs_;  // [agent], beside each other: the part that every frame reads
  std::vector<Ticks> next_updates_;
  std::vector<Handle> newest_players_;
  std::vector<std::uint32_t> free_;                                // numbers of removed agents; the last is given next
  std::vector<std::unique_ptr<CrossFadeChannel>> spare_channels_;  // of removed agents
};

/// Returns the player of the first channel that was asked for last, if that is a CrossFadeChannel that plays; else an
/// invalid or dead handle. It is kept beside the graphs, since a frame sets the speeds of many agents.
inline Handle newest_player(const AgentGraphs& graphs, std::uint32_t agent) { return graphs.newest_players_[agent]; }

/// Prefetches the data that an update reads of an agent first.
THRONG_ALWAYS_INLINE void prefetch_agent(const AgentGraphs& graphs, std::uint32_t agent) {
  prefetch(&graphs.graphs_[agent]);
  prefetch(&graphs.next_updates_[agent]);
}

}  // namespace throng::anim
