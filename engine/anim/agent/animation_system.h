#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/anim/agent/agent.h"
#include "engine/anim/agent/characters.h"
#include "engine/anim/agent/figures.h"
#include "engine/anim/agent/system_options.h"
#include "engine/anim/agent/system_parts.h"
#include "engine/anim/base/result.h"

namespace throng::anim {

/// The state of a crowd at a moment: the bytes of its blocks, and what its agents remember. See
/// AnimationSystem::snapshot.
class SystemSnapshot;

/// A crowd of agents, mostly of one character, of several if they are added (the façade, paper 2.1.2). One thread calls
/// it; the PUs are inside. It has three parts:
///     characters()      what agents are, and what they share; to be told at load time
///     agent(number)     one agent: takes requests, and tells how it moves
///     figures()         what updates did, and what they took
/// A frame comes after the requests:
///     advance(dt)       moves the clock of every agent, updated or not
///     update(agents)    poses those that level of detail chose, on all PUs; returns when they are done
class AnimationSystem {
 public:
  static Result<std::unique_ptr<AnimationSystem>> create(std::shared_ptr<const Character> character,
                                                         const SystemOptions& options);
  AnimationSystem(const AnimationSystem&) = delete;
  AnimationSystem& operator=(const AnimationSystem&) = delete;

  /// Takes all options at a frame boundary. Poses do not depend on any of them but the stream; the hash of what is
  /// written also depends on the format of palettes. Errors: the number of PUs is out of range, or a local store of a
  /// fixed size is too small; then nothing has changed.
  Status configure(const SystemOptions& options);
  const SystemOptions& options() const { return parts_.pus.options(); }
  /// Sets SystemOptions::trace, and makes nothing anew.
  void record_trace(Tracing tracing) { parts_.pus.record_trace(tracing, agent_count()); }
  /// Returns the executor that runs the PUs. Between updates it is free for the host's own jobs, at most options().pus
  /// at once.
  Executor& executor() const { return parts_.pus.executor(); }

  Characters& characters() { return characters_; }
  const Characters& characters() const { return characters_; }

  /// Sets the number of agents of character 0. New agents play nothing until asked. Every agent must play something
  /// before it is updated.
  void set_agent_count(std::uint32_t agents);
  /// Adds `count` agents of a character, and returns the number of the first. Their numbers follow those that there
  /// are. If there are agents of several characters, set_agent_count takes only 0.
  std::uint32_t add_agents(std::uint32_t count, std::uint32_t character);
  /// Adds one agent of each of these characters, in this order, and returns the number of the first.
  std::uint32_t add_agents(std::span<const std::uint8_t> characters);
  std::uint32_t agent_count() const { return parts_.population.count(); }
  Agent agent(std::uint32_t number) { return {parts_, number}; }
  AgentView agent(std::uint32_t number) const { return {parts_, number}; }

  void advance(Ticks delta) { parts_.population.advance(delta); }
  Ticks clock() const { return parts_.population.clock(); }
  void update(std::span<const AgentUpdate> agents) { parts_.frame.update(parts_.population, parts_.pus, agents); }

  /// Writes palettes of the clock, with all bones, of agents that were updated before. Level of detail is measured
  /// against them. The players and blends of an agent are wound back, however far ahead it stands; entities that
  /// remember more than a time (rag-dolls, gazes, placed feet) are taken as they are. Changes nothing: copies of blocks
  /// are updated and dropped.
  void pose_exactly(std::span<const ExactPose> agents) { parts_.exact.pose(parts_.population, parts_.pus, agents); }

  /// Copies the blocks of everything that changes. The memory of the snapshot is used again.
  void snapshot(SystemSnapshot& into) const;
  /// Puts a snapshot back; the crowd goes on to the same poses, bit for bit. Errors: the snapshot is of other
  /// characters, kinds of entities or bone orders, or of a schedule whose blocks have other sizes; then nothing has
  /// changed.
  Status restore(const SystemSnapshot& from);
  /// Moves living blocks together, in the order in which the scheduler reads them, and gives memory back.
  Compaction compact() { return parts_.population.compact(); }
  /// Begins clock, frames and pose hash anew, as if the system were new. There must be no agents and no shared graphs.
  void restart();

  Figures figures() const { return Figures(parts_); }

 private:
  AnimationSystem() = default;
  void agents_changed();

  SystemParts parts_;
  Characters characters_{parts_};
};

}  // namespace throng::anim
