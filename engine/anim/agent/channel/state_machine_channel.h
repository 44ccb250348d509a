#pragma once

#include <cstdint>
#include <memory>

#include "engine/anim/agent/channel/state_tree.h"

namespace throng::anim {

/// Plays a state machine: one state at a time, and a fade to it from the one before.
///
/// The clock decides when a transition is taken, to the tick: at the end of a clip, after a time, or when an input was
/// set. An agent that is updated late takes all missed transitions, each at its own time, so its poses do not depend on
/// when it was updated. A transition that comes while a fade runs neither snaps nor waits: an inertialiser leaves the
/// shown pose behind.
///
///     state ── fade ── inertialiser
///            /
///        state
class StateMachineChannel final : public Channel {
 public:
  /// `machine` is made for the character that plays it.
  explicit StateMachineChannel(std::shared_ptr<const StateMachine> machine);

  /// Sets an input from the clock on; call it through `Agent::change`. Flags and triggers are on at any value but 0.
  /// Returns false, and reports a misuse, if there is no such input or the value is not finite.
  bool set(std::uint32_t input, float value);
  /// Returns what an input was set to. A trigger that a transition has used is 0.
  float input(std::uint32_t index) const { return index < StateMachine::most_inputs ? asked_[index] : 0.0F; }

  /// Returns the state that plays, and when it was entered, as of the last update.
  std::uint32_t current() const { return current_; }
  Ticks entered_at() const { return entered_at_; }

  const char* fault(const EntityBuilder& build) const override;
  Handle state() const override { return inertialiser_.valid() ? inertialiser_ : tree_.root(); }
  bool update(const EntityBuilder& build) override;
  Ticks next_update() const override;
  void cut_fades(const EntityBuilder& build) override;
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<StateMachineChannel>(*this); }

 private:
  static constexpr int most_at_once = 16;  ///< transitions in an update: the rest is for the next one

  struct Due {
    Ticks time = never;
    std::uint16_t transition = 0;
  };
  const StateMachine::State& current_state() const { return machine_->states()[current_]; }
  Due next_transition(const EntityBuilder& build) const;
  Ticks due_time(const EntityBuilder& build, const StateMachine::Transition& transition) const;
  Ticks end_after(const EntityBuilder& build, Ticks from, Ticks fade) const;
  bool take_transitions(const EntityBuilder& build);
  bool take_inputs(const EntityBuilder& build);
  void enter(const EntityBuilder& build, std::uint8_t state, Ticks fade);
  void interrupt(const EntityBuilder& build, PlayedState played, std::uint8_t state, Ticks fade);
  bool update_played(const EntityBuilder& build);

  std::shared_ptr<const StateMachine> machine_;
  StateMachine::Inputs inputs_{};  // the values that the transitions have seen
  StateMachine::Inputs asked_{};   // the values that count from the next update on
  std::uint8_t current_ = 0;
  Ticks entered_at_{};
  Ticks inputs_at_{};  // when inputs_ changed
  Ticks due_ = never;  // the next transition, if no input changes

  StateTree tree_;
  StateTree left_;  // the tree that the inertialiser is leaving
  Handle inertialiser_;
  Ticks settled_at_{};  // when the newest interruption settles, by the clock
};

}  // namespace throng::anim
