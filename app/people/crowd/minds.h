#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "throng/ticks.h"

#include "app/character/roles.h"
#include "app/people/crowd/cast.h"
#include "app/people/crowd/habits.h"
#include "engine/base/random.h"

namespace throng::app {

/// Asks for another clip of an agent: it fades from the clip that it plays now into `clip`.
struct ClipRequest {
  std::uint32_t agent;
  Role role;
  int clip;            ///< index among its character's clips
  float fade_seconds;  ///< seconds of the crowd's clock
};

/// The state machine of each agent: the role that it has in mind, and the clip that it shows. The two differ where its
/// character has no clip for the role, and where others hold up an agent that wants to run. All of it follows from seed
/// and clock. Spans have one element an agent.
class CrowdMinds {
 public:
  /// Gives each agent its first role and clip. `cast` outlives this.
  CrowdMinds(const CrowdCast& cast, std::vector<Habit> habits, std::uint32_t seed);

  /// Returns whether the time has come for an agent to go over to another role.
  bool is_due(std::size_t agent, Ticks now) const {
    return !holds(agent) && (now >= arrivals_[agent].at || now >= next_changes_[agent]);
  }
  /// Begins a frame: clears requests and changes, then lets each of `agents`, which ascend, go over to another role if
  /// it is due.
  void decide(Ticks now, std::span<const std::uint32_t> agents);
  /// Lets the agent do `role` at once, if its character can, until the clock says `until`. Then next_role() decides.
  void interrupt(std::size_t agent, Role role, Ticks until);
  /// Shows `role` if the character can play it; the role that the agent has in mind stays.
  void show(std::size_t agent, Role role);

  /// Notes the role of an agent that another class moves, without a request.
  void note_role(std::size_t agent, Role role) {
    const auto played = cast_->of(agent).playable(role);
    if (played) roles_[agent] = *played, clips_[agent] = cast_->of(agent).clip(*played);
  }

  /// Lets each agent keep its role, by the clip that its character has for the role now. The requests then have only
  /// the agents that play another clip from now on.
  void take_new_clips(Ticks now);

  /// Keeps the agent in its role, except that it stops walking. Returns that change, if there is one; it is not among
  /// the requests.
  std::optional<ClipRequest> hold(std::size_t agent);
  /// Lets the agent go on as before.
  std::optional<ClipRequest> release(std::size_t agent);
  bool holds(std::size_t agent) const { return held_[agent] != 0; }

  std::span<const Habit> habits() const { return habits_; }
  std::span<const Role> intentions() const { return intentions_; }
  std::span<const Role> roles() const { return roles_; }  ///< shown
  std::span<const int> clips() const { return clips_; }   ///< index, or no_clip for a character that has none
  /// Takes the things that agents hold from now on; empty: none. They decide which roles agents go over to.
  void give(std::vector<HeldThing> things) { things_ = std::move(things); }
  /// Returns [agent] the things that agents hold; empty: none.
  std::span<const HeldThing> things() const { return things_; }
  Random& whim(std::size_t agent) { return whims_[agent]; }

  /// Returns the requests of this frame, at most one an agent.
  std::span<const ClipRequest> requests() const { return requests_; }
  /// Returns the agents that went over to another role in this frame, or chose their own role once more.
  std::span<const std::uint32_t> changed() const { return changed_; }

 private:
  void begin(std::size_t agent);
  HeldThing thing_of(std::size_t agent) const { return things_.empty() ? HeldThing::nothing : things_[agent]; }
  bool is_on_its_way(std::size_t agent) const;
  void take_new_clip(std::size_t agent);
  void change_role(std::size_t agent, Ticks now);
  void play_next_other(std::size_t agent);
  void request(std::size_t agent, Role role, int clip);
  void fade_to(std::size_t agent, Role role, int clip, float seconds);
  bool pass(std::size_t agent, Role role, int clip);
  void arrive(std::size_t agent);
  std::optional<ClipRequest> show_apart(std::size_t agent, Role role);

  /// The role that follows when a clip that leads to it is over.
  struct Arrival {
    Ticks at;
    Role role;
    int clip;
    bool seated;  ///< true if that clip sits down
  };

  const CrowdCast* cast_;
  Ticks now_{};
  std::vector<Habit> habits_;
  std::vector<Role> intentions_, roles_;
  std::vector<int> clips_;
  std::vector<Ticks> next_changes_;
  std::vector<Arrival> arrivals_;
  std::vector<std::uint8_t> held_;
  std::vector<HeldThing> things_;
  std::vector<Random> whims_;  // [agent] its own random numbers
  std::vector<ClipRequest> requests_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace throng::app
