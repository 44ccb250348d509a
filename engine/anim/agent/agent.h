#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

#include "throng/ids.h"

#include "engine/anim/agent/agent_motion.h"
#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/agent/system_parts.h"
#include "engine/anim/base/misuse.h"

namespace throng::anim {

/// A view of one agent of an AnimationSystem, to read from. It is as cheap to copy as a pointer. When the agent is
/// gone, it shows an agent that has nothing and plays nothing.
class AgentView {
 public:
  AgentView(const SystemParts& system, AgentId id) : population_(&system.population), id_(id) {}

  AgentId id() const { return id_; }
  /// Returns the agent's number in the system.
  std::uint32_t number() const { return id_.number; }
  /// Returns whether the agent is in the system.
  bool exists() const { return population_->numbers().has(id_); }
  /// Returns the character that it was added as.
  CharacterId character_id() const;
  std::uint32_t character_number() const { return character_id().number; }
  const Character& character() const { return *agents().character; }

  std::size_t channel_count() const { return graphs().channel_count(index()); }
  /// Returns the id of the channel at a place, from the bottom up; an invalid one if there is none.
  ChannelId channel_id(std::size_t place) const;
  /// Returns a channel of this type; null if there is none of this id, or it was added as another type.
  template <typename Derived = Channel>
  const Derived* channel(ChannelId id) const {
    return as<Derived, Channel>(own(id));
  }
  std::size_t post_process_count() const { return graphs().post_process_count(index()); }
  ProcessId post_process_id(std::size_t place) const;
  template <typename Derived = PostProcess>
  const Derived* post_process(ProcessId id) const {
    return as<Derived, PostProcess>(own(id));
  }

  /// Returns the graph of the entities that its channels and post processes made.
  const PoseGraph& graph() const { return graphs().graph(index()); }
  const PoseProgram& program() const { return *graph().program; }
  /// Returns the pools that hold these entities.
  const EntityPools& pools() const { return agents().pools; }

  /// Returns root motion, data keys and absolute root, at a frame boundary. Ask for the interval from the clock before
  /// advance() to the clock now, and ask before you make any request.
  AgentMotion motion() const {
    const CharacterAgents& alike = agents();
    const Ticks posed_at = exists() ? population_->posed_at(number()) : population_->clock();
    return {alike.pools, alike.clips, graph(), posed_at, alike.morph_blend()};
  }

  /// Prefetches the data that a change of the agent's channels reads and writes. A caller that changes many agents one
  /// after the other asks for the next agent before it changes this one.
  void prefetch() const;

  /// Returns whether the agent's present pose is known. It is not known while the agent stands ahead of the clock and
  /// the offset of an interrupted fade was captured in between, or its feet are placed.
  bool can_pose_exactly() const;
  /// Returns whether update() can take the agent back to the clock. It cannot while the agent stands ahead of the clock
  /// and one of its entities remembers more than a time (gazes, limbs that reach, held feet, springs, rag-dolls, kinds
  /// of a host's own) or is shared. Then update() leaves the agent where it stands.
  bool can_wind_back() const;

  /// Returns the last pose, [packet][components][16], in state space; nothing if none is kept. Only the schedule
  /// `levels` keeps it.
  std::span<const float> pose() const;

 protected:
  const AgentGraphs& graphs() const { return agents().agents; }
  std::uint32_t index() const { return exists() ? population_->numbers().member(number()).index : 0; }

  /// Returns a channel or post process; null if the agent has none of this id.
  const OwnedChannel* own(ChannelId channel) const {
    const std::optional<std::size_t> place = graphs().place(index(), channel);
    return place ? &graphs().channel(index(), *place) : nullptr;
  }
  const OwnedProcess* own(ProcessId process) const {
    const std::optional<std::size_t> place = graphs().place(index(), process);
    return place ? &graphs().post_process(index(), *place) : nullptr;
  }

  /// Returns the part as `Derived`, or null.
  template <typename Derived, typename Part>
  static Derived* as(const OwnedPart<Part>* part) {
    if (part == nullptr) return nullptr;
    if constexpr (!std::is_same_v<Derived, Part>) {
      if (part->type != type_tag<Derived>()) return nullptr;
    }
    return static_cast<Derived*>(part->part.get());
  }

 private:
  const CharacterAgents& agents() const;

  const Population* population_;
  AgentId id_;
};

/// One agent (paper 2.1.2: "an agent handles requests and commands for its skeleton"). Every request takes effect at
/// the frame boundary at which it is made. An invalid request, for example to an agent that is gone, is a
/// misuse: it is reported, changes nothing, and returns false or an error.
class Agent : public AgentView {
 public:
  Agent(SystemParts& system, AgentId id) : AgentView(system, id), system_(&system) {}

  /// Plays a clip on the first channel, which is a CrossFadeChannel unless another was added first. Returns false if
  /// blends that stay (masked or held) take all places of the channel's tree. Returns false also if a local store of a
  /// fixed size has no room for the fade; then the clip has replaced all at once.
  bool play(const PlayRequest& request);
  /// Plays a clip on another channel, which is a CrossFadeChannel. A layer for which a local store of a fixed size has
  /// no room at all plays nothing afterwards.
  bool play(ChannelId channel, const PlayRequest& request);
  /// Changes the speed of the last requested clip from now on, without a jump. The first channel is as for play().
  bool set_speed(double speed);

  /// Lays a channel over the agent's channels. Errors: it is null, or not valid for this character; the agent's
  /// graph would have a cycle, or would be too large for a local store of a fixed size; then the agent is as it was.
  template <typename Derived>
  Result<ChannelId> add_channel(std::unique_ptr<Derived> channel, const LayerSettings& settings = {}) {
    return add_channel(std::move(channel), type_tag<Derived>(), settings);
  }
  /// Removes a channel. The channels after it move up one place.
  bool remove_channel(ChannelId channel);
  /// Sets how much a channel, but not the first, covers the channels before it, 0 to 1. The weight moves there evenly
  /// in `fade`, from where it is.
  bool set_channel_weight(ChannelId channel, float weight, Ticks fade = {});
  /// Sets parameters of a channel, which alone is then updated: agent.change<BlendSpaceChannel>(walk, [&](auto&
  /// channel) { channel.set_parameter(speed); }). Errors: those of add_channel, and the channel was added as another
  /// type.
  template <typename Derived, typename Change>
  Status change(ChannelId channel, Change&& change_parameters, const char* call = "Agent::change") {
    auto* const found = as<Derived, Channel>(own(channel));
    if (found == nullptr) return refuse({call, "the agent has no channel of this id and type"});
    std::forward<Change>(change_parameters)(*found);
    return channel_changed(channel, call);
  }

  /// Adds a process, which changes the pose after the processes before it. Errors: those of add_channel.
  template <typename Derived>
  Result<ProcessId> add_post_process(std::unique_ptr<Derived> process) {
    return add_post_process(std::move(process), type_tag<Derived>());
  }
  bool remove_post_process(ProcessId process);
  /// Takes a process without its entities, so that another agent of the same character can have it; null if the agent
  /// has none of this id and type.
  template <typename Derived>
  std::unique_ptr<Derived> take_post_process(ProcessId process) {
    if (post_process<Derived>(process) == nullptr) {
      report_misuse({"Agent::take_post_process", "the agent has no post process of this id and type"});
      return nullptr;
    }
    return std::unique_ptr<Derived>(static_cast<Derived*>(take(process).release()));
  }
  /// Sets parameters of a post process, which alone is then updated: agent.change_process<LookAtProcess>(gaze,
  /// [&](auto& look) { look.look_at(target); }). Errors: those of add_channel; then the process lets go of its
  /// entities.
  template <typename Derived, typename Change>
  Status change_process(ProcessId process, Change&& change_parameters, const char* call = "Agent::change_process") {
    auto* const found = as<Derived, PostProcess>(own(process));
    if (found == nullptr) return refuse({call, "the agent has no post process of this id and type"});
    std::forward<Change>(change_parameters)(*found);
    return process_changed(process, call);
  }

  // Calls of many agents at once (many_requests.h) make these on several threads, each for another agent.

  /// Does set_speed(), and returns why it cannot, in one sentence; null if it can.
  const char* try_set_speed(double speed) const;
  /// Says what became of a change of a part that may keep its entities.
  enum class Changed : std::uint8_t { done, needs_entities, no_such_part };
  /// Does change() if the channel keeps its entities. If it needs others, its parameters are set, and change() is to be
  /// called again.
  template <typename Derived, typename Change>
  Changed change_in_place(ChannelId channel, const Change& change_parameters) const {
    return change_in_place<Derived>(own(channel), change_parameters);
  }
  template <typename Derived, typename Change>
  Changed change_in_place(ProcessId process, const Change& change_parameters) const {
    return change_in_place<Derived>(own(process), change_parameters);
  }

 private:
  AgentGraphs& own_graphs() const { return system_->population.character_of(number()).agents; }
  EntityBuilder builder() const { return system_->population.builder(number()); }
  template <typename Derived, typename Part, typename Change>
  Changed change_in_place(const OwnedPart<Part>* part, const Change& change_parameters) const {
    auto* const found = as<Derived, Part>(part);
    if (found == nullptr) return Changed::no_such_part;
    change_parameters(*found);
    const bool done = own_graphs().update_alone(builder(), index(), *found, AgentGraphs::Entities::stay);
    return done ? Changed::done : Changed::needs_entities;
  }
  template <typename Change>
  Status settle(Change&& change_graph) {
    return system_->pus.settle(system_->population, number(), std::forward<Change>(change_graph));
  }
  Result<ChannelId> add_channel(std::unique_ptr<Channel> channel, TypeTag type, const LayerSettings& settings);
  Result<ProcessId> add_post_process(std::unique_ptr<PostProcess> process, TypeTag type);
  std::unique_ptr<PostProcess> take(ProcessId process);
  CrossFadeChannel* first_channel() const;
  bool play(CrossFadeChannel& channel, const PlayRequest& request);
  const char* fault_of(const PlayRequest& request) const;
  Status channel_changed(ChannelId channel, const char* call);
  Status process_changed(ProcessId process, const char* call);

  SystemParts* system_;
};

}  // namespace throng::anim
