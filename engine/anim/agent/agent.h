#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "engine/anim/agent/agent_motion.h"
#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/agent/system_parts.h"

namespace throng::anim {

/// A view of one agent of an AnimationSystem, to read from. It is as cheap to copy as a pointer, and valid until the
/// system has fewer agents.
class AgentView {
 public:
  AgentView(const SystemParts& system, std::uint32_t number)
      : agents_(&system.population.character_of(number)), population_(&system.population), number_(number) {}

  /// Returns the agent's number in the system.
  std::uint32_t number() const { return number_; }
  /// Returns the number of its character, as add_agents was told.
  std::uint32_t character_number() const { return population_->member(number_).character; }
  const Character& character() const { return *agents_->character; }

  std::size_t channel_count() const { return graphs().channel_count(index()); }
  template <typename Derived = Channel>
  const Derived& channel(std::size_t place) const {
    return static_cast<const Derived&>(graphs().channel(index(), place));
  }
  std::size_t post_process_count() const { return graphs().post_process_count(index()); }
  template <typename Derived = PostProcess>
  const Derived& post_process(std::size_t place) const {
    return static_cast<const Derived&>(graphs().post_process(index(), place));
  }

  /// Returns the graph of the entities that its channels and post processes made.
  const PoseGraph& graph() const { return graphs().graph(index()); }
  const PoseProgram& program() const { return *graph().program; }
  /// Returns the pools that hold these entities.
  const EntityPools& pools() const { return agents_->pools; }

  /// Returns root motion, data keys and absolute root, at a frame boundary. Ask for the interval from the clock before
  /// advance() to the clock now, and ask before you make any request.
  AgentMotion motion() const {
    return {pools(), agents_->clips, graph(), population_->posed_at(number_), agents_->morph_blend()};
  }

  /// Returns whether the agent's pose of now is known. It is not known while the agent stands ahead of the clock and
  /// the offset of an interrupted fade was captured in between, or its feet are placed.
  bool can_pose_exactly() const;
  /// Returns whether update() can take the agent back to the clock. It cannot while the agent stands ahead of the clock
  /// and one of its entities remembers more than a time (gazes, limbs that reach, held feet, springs, rag-dolls, kinds
  /// of a host's own) or is shared. Then update() leaves the agent where it stands.
  bool can_wind_back() const;

  /// Returns the last pose, [packet][components][16], in state space. Only the schedule `levels` keeps it.
  std::span<const float> pose() const;

 protected:
  const AgentGraphs& graphs() const { return agents_->agents; }
  std::uint32_t index() const { return population_->member(number_).index; }

 private:
  const CharacterAgents* agents_;
  const Population* population_;
  std::uint32_t number_;
};

/// One agent (paper 2.1.2: "an agent handles requests and commands for its skeleton"). Every request takes effect at
/// the frame boundary at which it is made.
class Agent : public AgentView {
 public:
  Agent(SystemParts& system, std::uint32_t number) : AgentView(system, number), system_(&system) {}

  /// Plays a clip on the first channel, which is a CrossFadeChannel unless another was added first. Returns false if
  /// blends that stay (masked or held) take all places of the channel's tree. Returns false also if a local store of a
  /// fixed size has no room for the fade; then the clip has replaced all at once.
  bool play(const PlayRequest& request);
  /// Plays what was asked for last at another speed from now on, without a jump. The first channel is as for play().
  void set_speed(double speed);

  /// Lays a channel over those that the agent has. Errors: the agent's graph would have a cycle, or would be too large
  /// for a local store of a fixed size; then the agent is as it was.
  Status add_channel(std::unique_ptr<Channel> channel, const LayerSettings& settings = {});
  /// Removes a channel. The channels after it move up one place.
  void remove_channel(std::size_t place);
  /// Sets how much a channel, but not the first, covers those before it.
  void set_channel_weight(std::size_t place, float weight);
  /// Sets parameters of a channel, which is then updated: agent.change<BlendSpaceChannel>(0, [&](auto& walk) {
  /// walk.set_parameter(speed); }).
  template <typename Derived, typename Change>
  Status change(std::size_t place, Change&& change_parameters) {
    std::forward<Change>(change_parameters)(static_cast<Derived&>(graphs().channel(index(), place)));
    return channel_changed();
  }

  /// Adds a process that the pose passes through, after those that were added before. Errors: those of add_channel.
  Status add_post_process(std::unique_ptr<PostProcess> process);
  void remove_post_processes();
  /// Takes the last of at least one process, without its entities, so that another agent of the same character can have
  /// it.
  std::unique_ptr<PostProcess> take_last_post_process();
  /// Sets parameters of a post process, which alone is then updated: agent.change_process<LookAtProcess>(0, [&](auto&
  /// look) { look.look_at(target); }). Errors: those of add_channel; then the process lets go of its entities.
  template <typename Derived, typename Change>
  Status change_process(std::size_t place, Change&& change_parameters) {
    std::forward<Change>(change_parameters)(static_cast<Derived&>(graphs().post_process(index(), place)));
    return process_changed(place);
  }

 private:
  AgentGraphs& own_graphs() const { return system_->population.character_of(number()).agents; }
  EntityBuilder builder() const { return system_->population.builder(number()); }
  template <typename Change>
  Status settle(Change&& change_graph) {
    return system_->pus.settle(system_->population, number(), std::forward<Change>(change_graph));
  }
  Status channel_changed();
  Status process_changed(std::size_t place);

  SystemParts* system_;
};

}  // namespace throng::anim
