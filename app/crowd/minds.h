#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "app/character/roles.h"
#include "app/crowd/cast.h"
#include "app/crowd/habits.h"
#include "app/crowd/random.h"
#include "engine/anim/base/units.h"

namespace throng::app {

/// An agent changes what it does: ease from the clip it plays now into `clip`.
struct ClipRequest {
  std::uint32_t agent;
  Role role;
  int clip;            ///< index among its character's clips
  float fade_seconds;  ///< of the crowd's clock
};

/// Each agent's state machine: what it has in mind, and the clip that shows it. The two differ where its character has
/// no clip for a role, and where one who means to run is held up by others. Depends on nothing but seed and clock.
/// Spans have one element an agent.
class CrowdMinds {
 public:
  /// `cast` outlives it.
  CrowdMinds(const CrowdCast& cast, std::vector<Habit> habits, std::uint32_t seed);

  /// Begins a frame: forgets requests and changes, then lets everyone whose time has come go over to another role.
  void decide(anim::Ticks now);
  /// Does `role`, if the character can, at once and until the clock says `until`; as next_role decides from then on.
  void interrupt(std::size_t agent, Role role, anim::Ticks until);
  /// Shows `role`, which the character can play, whatever the agent has in mind.
  void show(std::size_t agent, Role role);

  /// From now on it does not change what it does, but to stop walking: that change, if there is one, is returned and
  /// not among the requests.
  std::optional<ClipRequest> hold(std::size_t agent);
  /// It goes on as before.
  std::optional<ClipRequest> release(std::size_t agent);
  bool holds(std::size_t agent) const { return held_[agent] != 0; }

  std::span<const Habit> habits() const { return habits_; }
  std::span<const Role> intentions() const { return intentions_; }
  std::span<const Role> roles() const { return roles_; }  ///< shown
  std::span<const int> clips() const { return clips_; }   ///< index, or no_clip for a character that has none
  Random& whim(std::size_t agent) { return whims_[agent]; }

  /// Of this frame, at most one an agent.
  std::span<const ClipRequest> requests() const { return requests_; }
  /// Agents that went over to another role in this frame, or chose the one that they have once more.
  std::span<const std::uint32_t> changed() const { return changed_; }

 private:
  void begin(std::size_t agent);
  void change_role(std::size_t agent, anim::Ticks now);
  void play_next_other(std::size_t agent);
  void request(std::size_t agent, Role role, int clip);
  void fade_to(std::size_t agent, Role role, int clip, float seconds);
  bool pass(std::size_t agent, Role role, int clip);
  void arrive(std::size_t agent);
  std::optional<ClipRequest> show_apart(std::size_t agent, Role role);

  /// What is done when the clip is over that leads to it.
  struct Arrival {
    anim::Ticks at;
    Role role;
    int clip;
    bool seated;  ///< whether that clip sits down
  };

  const CrowdCast* cast_;
  anim::Ticks now_ = 0;
  std::vector<Habit> habits_;
  std::vector<Role> intentions_, roles_;
  std::vector<int> clips_;
  std::vector<anim::Ticks> next_changes_;
  std::vector<Arrival> arrivals_;
  std::vector<std::uint8_t> held_;
  std::vector<Random> whims_;  // each agent's own chance
  std::vector<ClipRequest> requests_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace throng::app
