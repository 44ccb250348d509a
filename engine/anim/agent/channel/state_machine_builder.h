#pragma once

#include <memory>
#include <string>

#include "engine/anim/agent/channel/state_machine.h"

namespace throng::anim {

/// Checks a description, and finds what its names mean. Each step is an error or adds its part to the machine.
class StateMachineBuilder {
 public:
  StateMachineBuilder(const MachineDescription& description, const Character& character)
      : description_(&description), character_(&character), machine_(new StateMachine) {}

  Result<std::shared_ptr<const StateMachine>> build();

 private:
  Status take_inputs();
  Status take_states();
  Status take_state(const MachineDescription::State& from);
  Status take_clip(const MachineDescription::State& from, StateMachine::State& state) const;
  Status take_space(const MachineDescription::State& from, StateMachine::State& state) const;
  Status take_inputs_of_space(const MachineDescription::State& from, StateMachine::State& state) const;
  Status take_points(const MachineDescription::State& from, StateMachine::State& state) const;
  Status take_plane(const MachineDescription::State& from, StateMachine::State& state) const;
  Status take_transitions();
  Status take_transition(const MachineDescription::Transition& from, std::uint16_t index);
  Status take_times(const MachineDescription::Transition& from, StateMachine::Transition& transition) const;
  Status check_source(const MachineDescription::Transition& from, const StateMachine::Transition& transition) const;
  Status take_start();
  Status check_reach() const;
  Status check_rest() const;
  Result<int> clip_of(const std::string& name) const;

  const MachineDescription* description_;
  const Character* character_;
  std::shared_ptr<StateMachine> machine_;
};

}  // namespace throng::anim
