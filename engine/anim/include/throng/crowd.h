#pragma once

#include "throng/agent.h"
#include "throng/character.h"
#include "throng/formats.h"
#include "throng/host.h"
#include "throng/ids.h"
#include "throng/many.h"
#include "throng/pose_request.h"
#include "throng/result.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

/// The joints that an update writes of each agent of a character, in model space: for a server that draws nothing, for
/// sockets, or as palettes in another form. Without a palette, only the bones that they need are posed.
struct JointOutput {
  std::span<const int> bones{};  ///< these, in this order; empty: all bones
  std::optional<int> skin{};     ///< instead: the matrices of this skin of the file, in the order of its joints
  JointFormat format = JointFormat::transforms;
};

struct CrowdOptions {
  int pus = 1;                        ///< threads that pose, the caller's included, 1 to 256
  std::size_t local_store_bytes = 0;  ///< of each PU; 0: as large as its caches and the agents ask for
  PaletteFormat palettes = PaletteFormat::matrices;
  Executor* executor = nullptr;  ///< a host's job system, which outlives the crowd; null: threads of its own
  bool hash = false;             ///< Debug::pose_hash
  bool trace = false;            ///< notes what each PU does, for Debug::trace
};

/// The weight of a bone and of all bones below it.
struct BoneWeight {
  int bone = 0;
  float weight = 1.0F;  ///< 0 to 1
};

/// The state of a crowd at a moment. The caller owns it, and can use its memory again and again.
class Snapshot {
 public:
  Snapshot();
  ~Snapshot();
  Snapshot(Snapshot&&) noexcept;
  Snapshot& operator=(Snapshot&&) noexcept;
  std::size_t bytes() const;

 private:
  friend class Crowd;
  struct State;
  std::unique_ptr<State> state_;
};

/// Thousands of agents, of one character or of several. One thread calls it; the PUs are inside. A call that breaks its
/// contract, or any call of a moved-from crowd, is a misuse (host.h): it is reported and ignored. A frame is
///
///     crowd.agent(id).play(...)    requests
///     crowd.advance(16ms)          moves the clock of every agent, posed or not
///     crowd.update(requests)       poses these, on all PUs; returns when their palettes are written
///
/// In a child of fork() a crowd with threads of its own can be destroyed and read, and takes requests, but it poses no
/// agent before it is configured there. A crowd that a child makes has no such limit.
///
/// Poses depend on clips, times and weights alone: not on the number of PUs, on neighbours, nor on the machine.
class Crowd {
 public:
  /// Errors: the character is empty, an option is out of its range.
  static Result<Crowd> create(const Character& character, const CrowdOptions& options = {});
  ~Crowd();
  Crowd(Crowd&&) noexcept;
  Crowd& operator=(Crowd&&) noexcept;
  /// Changes options between frames. Poses stay the same.
  Result<Done> configure(const CrowdOptions& options);

  // Characters. The first is number 0. At most 32 at a time.
  Result<CharacterId> add(const Character& character);
  /// Errors: agents play it, or it is the only one.
  Result<Done> remove(CharacterId character);
  /// Takes a character with other clips, which was made of the character that it replaces (Character::with_clips,
  /// without), between frames. Agents go on where they are, to the bit. Older snapshots cannot be restored, and keep
  /// the clips that they know. Errors: an agent plays a clip that leaves (during a fade away from it too, and after an
  /// interrupted fade until it is posed twice), or has it in a blend space or state machine. A place goes from one clip
  /// to another at once. A local store of a fixed size is too small. Then nothing has changed.
  Result<Done> replace(CharacterId character, const Character& with_other_clips);
  /// Returns a character; an empty one if none has this id.
  Character character(CharacterId character) const;
  /// Returns the bytes from one palette of a character to the next in an array of palettes.
  std::size_t palette_bytes(CharacterId character) const;
  /// Sets which joints an update writes where PoseRequest::joints says. Errors: the character has no such bone or skin,
  /// or not this format; then nothing has changed.
  Result<Done> write_joints(CharacterId character, const JointOutput& output);
  /// Returns the bytes that an update writes to PoseRequest::joints.
  std::size_t joint_bytes(CharacterId character) const;
  /// Adds weights of bones. A bone inside of another's subtree wins. Bones in no subtree weigh `elsewhere`.
  MaskId add_mask(CharacterId character, std::span<const BoneWeight> bones, float elsewhere = 0.0F);
  /// Adds a step of the host's own, for Agent::add.
  Result<StepId> add_step(CharacterId character, const StepKind& kind);

  // Agents. At most 2^20.
  AgentId add_agent(CharacterId character = 0);
  /// Adds several. The span is valid until agents are added or removed.
  std::span<const AgentId> add_agents(std::uint32_t count, CharacterId character = 0);
  bool remove_agent(AgentId agent);
  Agent agent(AgentId agent);
  /// Takes requests to many agents at a time.
  ManyAgents many();
  /// Returns all agents, in the order in which they were added.
  std::span<const AgentId> agents() const;
  /// Returns a number above all agents' numbers, for arrays that have a place for each.
  std::uint32_t number_limit() const;

  // Frames.
  void advance(Ticks delta);
  Ticks clock() const;
  void update(std::span<const PoseRequest> requests);
  /// Writes palettes for the time of the clock, with all bones at any level of detail. Changes nothing. They are of
  /// matrices, 48 bytes for each of Character::palette_entries, also in a crowd whose palettes are packed.
  void pose_exactly(std::span<const PoseRequest> requests);
  /// Writes the local transforms of an agent at the clock, relative to the parent, in the order of its bones: for a
  /// network or an editor. `into` has room for all. Returns false if its present pose is not known.
  bool local_pose(AgentId agent, std::span<LocalTransform> into);

  /// Returns a box that holds the surface of an agent in its pose at the clock, processes and morphs included, in model
  /// space: move it by the agent's place. It needs no palettes, and takes a few microseconds. An agent whose present
  /// pose is not known, or that plays nothing, has the box around Character::bounds().
  BoundingBox bounds(AgentId agent);

  void snapshot(Snapshot& into) const;
  /// Puts a snapshot of this crowd back. The crowd goes on to the same poses, bit for bit. A snapshot of another crowd
  /// is a misuse.
  Result<Done> restore(const Snapshot& from);

  class Debug debug() const;
  detail::CrowdParts& parts() const;

 private:
  explicit Crowd(std::unique_ptr<detail::CrowdParts> parts);
  /// Reports a call of a crowd that was moved from, and returns whether it is one.
  bool is_gone(const char* call) const;
  std::unique_ptr<detail::CrowdParts> parts_;
};

}  // namespace throng
