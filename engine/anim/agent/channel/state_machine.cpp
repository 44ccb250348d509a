#include "engine/anim/agent/channel/state_machine.h"

#include <algorithm>

#include "engine/anim/agent/channel/state_machine_builder.h"

namespace throng::anim {

bool StateMachine::Condition::holds(const Inputs& inputs) const {
  const float own = inputs[input];
  switch (is) {
    case Is::less:
      return own < value;
    case Is::at_most:
      return own <= value;
    case Is::more:
      return own > value;
    default:
      return own >= value;
  }
}

bool StateMachine::Transition::holds(const Inputs& inputs) const {
  return std::ranges::all_of(when, [&](const Condition& one) { return one.holds(inputs); });
}

Result<std::shared_ptr<const StateMachine>> StateMachine::create(const MachineDescription& description,
                                                                 const Character& character) {
  StateMachineBuilder builder(description, character);
  return builder.build();
}

std::optional<std::uint32_t> StateMachine::find_input(std::string_view name) const {
  const auto found = std::ranges::find(inputs_, name, &MachineDescription::Input::name);
  return found == inputs_.end() ? std::nullopt : std::optional(static_cast<std::uint32_t>(found - inputs_.begin()));
}

std::optional<std::uint32_t> StateMachine::find_state(std::string_view name) const {
  const auto found = std::ranges::find(states_, name, &State::name);
  return found == states_.end() ? std::nullopt : std::optional(static_cast<std::uint32_t>(found - states_.begin()));
}

void StateMachine::for_each_clip(const std::function<void(int)>& visit) const {
  for (const State& state : states_) {
    if (state.points != nullptr) {
      for (const BlendPoint& point : *state.points) visit(point.clip);
    } else if (state.plane != nullptr) {
      for (const BlendPoint2d& point : state.plane->all()) visit(point.clip);
    } else {
      visit(state.clip.clip);
    }
  }
}

void StateMachine::use_triggers(const Transition& taken, Inputs& inputs) const {
  for (const Condition& condition : taken.when) {
    if (inputs_[condition.input].kind == MachineDescription::Input::Kind::trigger) inputs[condition.input] = 0.0F;
  }
}

}  // namespace throng::anim
