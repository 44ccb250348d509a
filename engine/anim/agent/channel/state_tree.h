#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "engine/anim/agent/channel/state_machine.h"
#include "engine/anim/agent/simple_channel.h"

namespace throng::anim {

/// Plays a state of a machine, as a channel that it holds by value. Copying one allocates nothing.
class PlayedState {
 public:
  PlayedState() = default;
  /// Plays the state from the clock of the builder on.
  PlayedState(const EntityBuilder& build, const StateMachine::State& state, const StateMachine::Inputs& inputs);

  Handle root() const { return channel() == nullptr ? Handle{} : channel()->state(); }
  /// Gives the inputs to a blend space. Returns whether root(), or an entity that it reads, is another than before.
  bool follow(const EntityBuilder& build, const StateMachine::State& state, const StateMachine::Inputs& inputs);
  /// Updates the parts that are due. Returns as follow().
  bool update(const EntityBuilder& build);
  Ticks next_update() const { return channel() == nullptr ? never : channel()->next_update(); }
  void visit_handles(const std::function<void(Handle&)>& visit);
  void destroy(const EntityBuilder& build);

 private:
  using Played = std::variant<std::monostate, SimpleChannel, BlendSpaceChannel, BlendSpace2dChannel>;
  Channel* channel();
  const Channel* channel() const { return const_cast<PlayedState*>(this)->channel(); }
  static Played make(const StateMachine::State& state, const StateMachine::Inputs& inputs);

  Played played_;
};

/// The entities of a state that plays, and of a fade to it from the state before.
///
///     before ── fade
///             /
///         last
struct StateTree {
  std::array<PlayedState, 2> played;
  std::array<std::uint8_t, 2> states{};  ///< of the machine
  std::size_t count = 0;
  Handle fade;       ///< an ease blender; invalid where one state plays alone
  Ticks faded_at{};  ///< by the clock

  bool empty() const { return count == 0; }
  Handle root() const;
  bool is_fading(Ticks now) const { return count == 2 && faded_at > now; }

  /// Eases to another state from the clock on, or plays it alone if there is none before. There is at most one.
  void add(const EntityBuilder& build, PlayedState state, std::uint8_t number, Ticks over);
  /// Lets go of the state that has faded out. Returns whether there was one.
  bool end_fade(const EntityBuilder& build);
  /// Makes the blender read what the states show now.
  void join(const EntityBuilder& build) const;
  Ticks next_update() const;
  void visit_handles(const std::function<void(Handle&)>& visit);
  void destroy(const EntityBuilder& build);
};

}  // namespace throng::anim
