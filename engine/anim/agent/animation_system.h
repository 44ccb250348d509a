#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/anim/agent/agent.h"
#include "engine/anim/agent/characters.h"
#include "engine/anim/agent/figures.h"
#include "engine/anim/agent/many_requests.h"
#include "engine/anim/agent/system_options.h"
#include "engine/anim/agent/system_parts.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The state of a crowd at a moment: the bytes of its blocks, and what its agents remember. See
/// AnimationSystem::snapshot.
class SystemSnapshot;

/// A crowd of agents, mostly of one character, of several if they are added (the façade, paper 2.1.2). One thread calls
/// it; the PUs are inside. A call that breaks its contract is reported (base/misuse.h) and ignored. It has four parts:
///     characters()      what agents are, and what they share; set it up at load time
///     agent(id)         one agent: takes requests, and tells how it moves
///     many()            the same for many agents at a time, on all PUs
///     figures()         what updates did, and what they took
/// A frame comes after the requests:
///     advance(dt)       moves the clock of every agent, updated or not
///     update(agents)    poses the agents that level of detail chose, on all PUs; returns when they are posed
class AnimationSystem {
 public:
  /// Errors: the character is null or has no bones, and those of configure().
  static Result<std::unique_ptr<AnimationSystem>> create(std::shared_ptr<const Character> character,
                                                         const SystemOptions& options);
  /// No other thread is in a call of the system.
  ~AnimationSystem();
  AnimationSystem(const AnimationSystem&) = delete;
  AnimationSystem& operator=(const AnimationSystem&) = delete;

  /// Takes all options at a frame boundary. Poses do not depend on any of them but the stream; the hash of what is
  /// written also depends on the format of palettes. Errors: the number of PUs is out of range, or a local store of a
  /// fixed size is too small; then nothing has changed.
  Status configure(const SystemOptions& options);
  const SystemOptions& options() const { return parts_.pus.options(); }
  /// Sets SystemOptions::trace, and makes nothing anew.
  void record_trace(Tracing tracing) { parts_.pus.record_trace(tracing, number_limit()); }
  /// Returns the executor that runs the PUs. Between updates it is free for the host's own jobs, at most options().pus
  /// at once. In a child of fork(), which has no threads, it runs them in order.
  Executor& executor() const { return parts_.pus.executor(); }

  Characters& characters() { return characters_; }
  const Characters& characters() const { return characters_; }

  /// Adds an agent of a character, which plays nothing until it is asked to. There is such a character, and there are
  /// fewer than most_agents; else the id is invalid.
  AgentId add_agent(CharacterId character = 0);
  /// Adds `count` agents, and returns their ids in the order in which they were added. The span is valid until agents
  /// are added or removed.
  std::span<const AgentId> add_agents(std::uint32_t count, CharacterId character = 0);
  /// Adds one agent of each of these characters, given by their numbers, in this order.
  std::span<const AgentId> add_agents(std::span<const std::uint8_t> characters);
  /// Removes an agent, with its channels, post processes and entities. Numbers and memory are used again: a frame that
  /// removes as many as it adds allocates nothing. The other agents, and the hash of their poses, do not change.
  bool remove_agent(AgentId agent);
  /// Removes all agents but the first `count`, or adds agents of character 0 until there are so many.
  bool set_agent_count(std::uint32_t count);

  std::uint32_t agent_count() const { return parts_.population.numbers().count(); }
  /// Returns a number above all agents' numbers, for arrays that have a place for each. Numbers of removed agents are
  /// used again before new numbers.
  std::uint32_t number_limit() const { return parts_.population.numbers().number_limit(); }
  /// Returns the agents in the order in which they were added. The span is valid until agents are added or removed.
  std::span<const AgentId> agents() { return parts_.population.numbers().order().agents; }
  /// Returns the id of the agent that has this number; an invalid id if none has.
  AgentId id(std::uint32_t number) const;
  Agent agent(AgentId agent) { return {parts_, agent}; }
  AgentView agent(AgentId agent) const { return {parts_, agent}; }
  Agent agent(std::uint32_t number) { return {parts_, id(number)}; }
  AgentView agent(std::uint32_t number) const { return {parts_, id(number)}; }

  /// Moves the clock of every agent. `delta` is not negative.
  void advance(Ticks delta);
  Ticks clock() const { return parts_.population.clock(); }
  /// Poses these agents, each once. An invalid entry is left out: an agent that is gone or plays nothing, a
  /// bone level that its character lacks, a palette that is not aligned, an agent that comes twice.
  void update(std::span<const PoseRequest> agents);

  /// Writes palettes or local transforms for the clock, with all bones, of agents that were updated before. Level of
  /// detail is measured against these. The players and blends of an agent are wound back, however far ahead it stands;
  /// entities that remember more than a time (rag-dolls, gazes, placed feet) are taken as they are. Changes nothing:
  /// copies of blocks are updated and dropped.
  void pose_exactly(std::span<const ExactPose> agents);

  /// Copies the blocks of everything that changes. The memory of the snapshot is used again.
  void snapshot(SystemSnapshot& into) const;
  /// Puts a snapshot back; the crowd goes on to the same poses, bit for bit, unless it reads another stream now.
  /// Errors: the snapshot has other characters, kinds of entities or bone orders, or a schedule whose blocks have
  /// other sizes; then nothing has changed.
  Status restore(const SystemSnapshot& from);
  /// Begins clock, frames and pose hash anew, as if the system were new. There are no agents.
  bool restart();

  Figures figures() const { return Figures(parts_); }
  /// Takes requests to many agents at a time.
  ManyRequests many() { return ManyRequests(parts_); }

 private:
  AnimationSystem() = default;
  bool can_run(const Turn& turn) const;
  bool add(std::uint32_t count, CharacterId character, const Turn& turn);
  void make_room();

  SystemParts parts_;
  Characters characters_{parts_};
};

}  // namespace throng::anim
