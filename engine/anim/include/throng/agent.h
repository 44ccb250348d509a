#pragma once

#include "throng/channels.h"
#include "throng/ids.h"
#include "throng/math.h"
#include "throng/processes.h"
#include "throng/result.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

namespace detail {
struct CrowdParts;
}
class StateMachine;

/// The way of an agent over some time, in its own space at the start.
struct RootMotion {
  Vec3 displacement{};  ///< metres
  float turn = 0.0F;    ///< radians about the vertical; to the left is positive
};

/// A data key that an agent has met: a step, a shot, a word.
struct DataKey {
  std::uint32_t name = 0;  ///< index of Character::data_key_names
  ClipId clip{};           ///< with its generation
  Ticks time{};            ///< of the clock, when it was met
  float weight = 0.0F;     ///< how much of the clip is felt, 0 to 1
};

/// A clip that does not loop has reached its end.
struct ClipEnd {
  ClipId clip{};  ///< with its generation
  Ticks time{};
  float weight = 0.0F;
};

/// Says which of the met data keys are delivered.
enum class KeyChoice : unsigned char {
  felt,      ///< keys of clips that have some weight
  heaviest,  ///< keys of the clip with the largest weight alone
  all        ///< keys of clips without weight too
};

/// One agent of a Crowd, as cheap to copy as a pointer. A request takes effect at the frame boundary at which it is
/// made. An invalid request, for example to an agent that is gone, is a misuse (host.h): it changes nothing, and
/// returns false, nothing or an error.
class Agent {
 public:
  Agent(detail::CrowdParts& crowd, AgentId id) : crowd_(&crowd), id_(id) {}

  AgentId id() const { return id_; }
  bool exists() const;
  CharacterId character() const;

  /// Plays a clip on the first channel, which fades between clips unless another kind was added first. It never waits
  /// and never snaps: a fade may be interrupted at any time. An agent has at most 64 parts: its channels, the clips
  /// that they play and fade, and its processes. Returns false also if there would be more.
  bool play(const Play& request) const;
  bool play(ChannelId channel, const Play& request) const;
  /// Changes the speed of the clip on the first channel, without a jump.
  bool set_speed(double speed) const;

  /// Lays a channel over the agent's channels. The first lies below all, whatever its layer says.
  Result<ChannelId> add_clips(const Layer& layer = {}) const;  ///< plays nothing until it is asked to
  Result<ChannelId> add(const BlendSpace& space, const Layer& layer = {}) const;
  Result<ChannelId> add(const BlendSpace2d& space, const Layer& layer = {}) const;
  /// Lays a state machine over the channels before it; Machine (state_machine.h) sets its inputs.
  Result<ChannelId> add(const StateMachine& machine, const Layer& layer = {}) const;
  /// Lays a slot over the channels before it. It plays one-shots, and costs nothing in between.
  Result<ChannelId> add_slot(const Layer& layer = {}) const;
  /// Plays a clip once in a slot. It fades out before its end by itself; Motion::for_each_end tells the end, if it is
  /// asked before Crowd::update. A clip that is not queued replaces the clips that play and wait, and neither snaps
  /// nor waits. Returns false if it is queued and four play and wait already. Returns false also if the local stores
  /// have no room; then the slot has stopped.
  bool play_once(ChannelId slot, const OneShot& shot) const;
  /// Returns whether a slot plays.
  bool is_playing(ChannelId slot) const;
  /// Sets the parameter of a blend space; of a plane, both parameters.
  bool set_parameter(ChannelId channel, float parameter) const;
  bool set_parameters(ChannelId channel, float x, float y) const;
  /// Sets how much a channel covers the channels below it, 0 to 1. The weight moves there evenly in `fade`.
  bool set_weight(ChannelId channel, float weight, Ticks fade = {}) const;
  bool remove(ChannelId channel) const;

  /// Adds a process, which changes the pose after the processes before it. Errors: the character has no such rig
  /// (Character::missing_rigs says why), or no bone of this name.
  Result<ProcessId> add(const LookAt& settings) const;
  Result<ProcessId> add(const Reach& settings) const;
  Result<ProcessId> add(const ChainReach& settings) const;
  Result<ProcessId> add(const FootPlacement& settings) const;
  Result<ProcessId> add(const Noise& settings) const;
  Result<ProcessId> add(const Springs& settings) const;
  Result<ProcessId> add(const Ragdoll& settings) const;
  Result<ProcessId> add(const Socket& settings) const;
  Result<ProcessId> add(StepId step) const;
  bool remove(ProcessId process) const;

  /// Reads and sets the agent's processes.
  class Processes processes() const;
  /// Tells how the agent moves over time.
  class Motion motion() const;

 private:
  friend class Machine;
  detail::CrowdParts* crowd_;
  AgentId id_;
};

/// The processes of an agent. Places are in metres in model space, unless a call says otherwise.
class Processes {
 public:
  Processes(detail::CrowdParts& crowd, AgentId agent) : crowd_(&crowd), agent_(agent) {}

  /// Sets the weight of a gaze, a reaching limb or chain, feet or springs, 0 to 1, and fades to it.
  bool set_weight(ProcessId process, float weight, Ticks fade = {}) const;
  bool look_at(ProcessId gaze, const Vec3& target, Ticks fade = {}) const;
  bool look_away(ProcessId gaze, Ticks fade) const;
  /// Sets the place that a limb or chain reaches for.
  bool reach(ProcessId limb, const Vec3& target) const;
  /// Tells feet or springs where the character stands in the world, at each frame: in the pose that the next
  /// Crowd::update writes. So move the agent by Motion::displacement after Crowd::advance, and call this then.
  bool set_placement(ProcessId process, const Place& model_in_world) const;
  /// Tells feet the ground below a leg, in world space: a point of it and its unit normal. Leg -1: all. The ground of a
  /// leg that the character has not is never read.
  bool set_ground(ProcessId feet, int leg, const Vec3& point, const Vec3& normal) const;
  /// Returns the ankle of a leg at the last update, before it was placed, in world space: where to look for the ground.
  /// It is 0 before the agent is posed, and for a leg that there is not.
  Vec3 ankle(ProcessId feet, int leg) const;

  /// Pushes the body nearest to `place` with an impulse, in kg m/s.
  bool push(ProcessId ragdoll, const Vec3& impulse, const Vec3& place) const;
  bool recover(ProcessId ragdoll, Ticks fade) const;
  /// Returns whether the agent has fallen, or is falling.
  bool is_down(ProcessId ragdoll) const;

  /// Returns where the attachment of a socket is, at the agent's last update.
  Place socket(ProcessId socket) const;

 private:
  detail::CrowdParts* crowd_;
  AgentId agent_;
};

/// The motion of an agent, found in closed form: it need not be posed. Ask for the interval from the clock before
/// Crowd::advance to the clock now, and ask before you make any request. Times are within a day of the clock. Any
/// number of agents may be asked at a time.
class Motion {
 public:
  Motion(const detail::CrowdParts& crowd, AgentId agent) : crowd_(&crowd), agent_(agent) {}

  /// Returns how the root motion of the clips moves the agent. A clip that walks in place has none, unless it was
  /// loaded with LoadOptions::walk_in_place.
  RootMotion displacement(Ticks from, Ticks to) const;
  /// Returns the value of a curve of its clips now; `name` is an index of Character::curve_names. It is blended by the
  /// weights of the clips; a clip without the curve counts as 0.
  float curve(std::uint32_t name) const;
  /// Writes the weight of each of Character::morph_names now; `into` has an element for each. They are blended as the
  /// pose is. Returns false if no clip that plays has morphs; then all are 0.
  bool morph_weights(std::span<float> into) const;
  /// Returns where a cut scene has the agent now; nothing if none plays.
  std::optional<Place> absolute_root() const;

  /// Calls visit(const DataKey&) for each key met in [from, to), a minute at most, clip after clip, each once. The
  /// visitor may change the crowd, which changes none of the keys that follow.
  template <typename Visit>
  void for_each_key(Ticks from, Ticks to, Visit&& visit, KeyChoice choice = KeyChoice::felt) const {
    visit_keys(
        from, to, choice, [](void* context, const DataKey& key) { (*static_cast<Function<Visit>*>(context))(key); },
        context_of(visit));
  }
  /// Calls visit(const ClipEnd&) for each clip that does not loop and arrived at its end in (from, to]. The visitor may
  /// change the crowd, too.
  template <typename Visit>
  void for_each_end(Ticks from, Ticks to, Visit&& visit) const {
    visit_ends(
        from, to, [](void* context, const ClipEnd& end) { (*static_cast<Function<Visit>*>(context))(end); },
        context_of(visit));
  }

 private:
  template <typename Visit>
  using Function = std::remove_reference_t<Visit>;
  template <typename Visit>
  static void* context_of(Visit& visit) {
    return const_cast<void*>(static_cast<const void*>(&visit));
  }
  void visit_keys(Ticks from, Ticks to, KeyChoice choice, void (*visit)(void*, const DataKey&), void* context) const;
  void visit_ends(Ticks from, Ticks to, void (*visit)(void*, const ClipEnd&), void* context) const;

  const detail::CrowdParts* crowd_;
  AgentId agent_;
};

}  // namespace throng
