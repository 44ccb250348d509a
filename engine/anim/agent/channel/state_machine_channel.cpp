#include "engine/anim/agent/channel/state_machine_channel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/base/misuse.h"

namespace throng::anim {

StateMachineChannel::StateMachineChannel(std::shared_ptr<const StateMachine> machine) : machine_(std::move(machine)) {
  if (machine_ == nullptr) return;
  inputs_ = asked_ = machine_->starting_inputs();
  current_ = machine_->start();
}

bool StateMachineChannel::set(std::uint32_t input, float value) {
  constexpr const char* call = "Machine::set";
  if (input >= machine_->input_count()) return report_misuse({call, "the state machine has no input of this number"});
  if (!std::isfinite(value)) return report_misuse({call, "an input is a finite number"});
  const bool is_number = machine_->input(input).kind == MachineDescription::Input::Kind::number;
  asked_[input] = is_number || value == 0.0F ? value : 1.0F;
  return true;
}

const char* StateMachineChannel::fault(const EntityBuilder& build) const {
  if (machine_ == nullptr) return "the state machine is null";
  bool has_all = true;
  machine_->for_each_clip([&](int clip) { has_all = has_all && build.has_clip(clip); });
  return has_all ? nullptr : "a state of the machine plays a clip that the character has not";
}

bool StateMachineChannel::update(const EntityBuilder& build) {
  bool changed = end_interruption(build, inertialiser_, left_);
  if (tree_.empty()) {
    inputs_ = asked_;
    inputs_at_ = build.now();
    enter(build, current_, Ticks{});
    changed = true;
  }
  changed = take_transitions(build) || changed;  // that were due before the inputs changed
  changed = take_inputs(build) || changed;
  changed = tree_.end_fade(build) || changed;
  changed = update_played(build) || changed;
  if (inertialiser_.valid()) build.as<Inertialiser>(inertialiser_).target = tree_.root();
  return changed;
}

bool StateMachineChannel::take_inputs(const EntityBuilder& build) {
  if (asked_ == inputs_) return false;
  inputs_ = asked_;
  inputs_at_ = build.now();
  bool changed = take_transitions(build);
  for (std::size_t i = 0; i < tree_.count; ++i) {
    changed = tree_.played[i].follow(build, machine_->states()[tree_.states[i]], inputs_) || changed;
  }
  tree_.join(build);
  return changed;
}

bool StateMachineChannel::take_transitions(const EntityBuilder& build) {
  bool changed = false;
  for (int taken = 0; taken < most_at_once; ++taken) {
    const Due due = next_transition(build);
    due_ = due.time;
    if (due.time > build.now()) return changed;
    const StateMachine::Transition& transition = machine_->transition(due.transition);
    machine_->use_triggers(transition, inputs_);
    machine_->use_triggers(transition, asked_);
    enter(build.at(due.time), transition.to, transition.fade);
    changed = true;
  }
  return changed;
}

// Takes the first in the order of the machine, where several are due at the same time.
StateMachineChannel::Due StateMachineChannel::next_transition(const EntityBuilder& build) const {
  Due next;
  for (const std::uint16_t index : current_state().transitions) {
    const StateMachine::Transition& transition = machine_->transition(index);
    if (!transition.holds(inputs_)) continue;
    const Ticks time = due_time(build, transition);
    if (time < next.time) next = {.time = time, .transition = index};
  }
  return next;
}

Ticks StateMachineChannel::due_time(const EntityBuilder& build, const StateMachine::Transition& transition) const {
  const Ticks from = std::max(entered_at_ + transition.after, inputs_at_);
  return transition.at_end ? end_after(build, from, transition.fade) : from;
}

// Begins the fade so that it ends with the clip, or with one of its loops.
Ticks StateMachineChannel::end_after(const EntityBuilder& build, Ticks from, Ticks fade) const {
  const Ticks length = std::max(build.length_of(tree_.played[tree_.count - 1].root()), Ticks{1});
  const Ticks first = entered_at_ + length - fade;
  if (first >= from || !current_state().clip.loop) return std::max(first, from);
  const std::int64_t loops = (from - first + length - Ticks{1}) / length;
  return first + length * loops;
}

void StateMachineChannel::enter(const EntityBuilder& build, std::uint8_t state, Ticks fade) {
  tree_.end_fade(build);
  PlayedState played(build, machine_->states()[state], inputs_);
  current_ = state;
  entered_at_ = build.now();
  if (!tree_.empty() && fade > Ticks{} && (tree_.is_fading(build.now()) || settled_at_ > build.now())) {
    interrupt(build, std::move(played), state, fade);
    return;
  }
  if (fade <= Ticks{}) destroy_entities(build);
  tree_.add(build, std::move(played), state, fade);
}

void StateMachineChannel::interrupt(const EntityBuilder& build, PlayedState played, std::uint8_t state, Ticks fade) {
  begin_interruption(build, inertialiser_, tree_, left_);
  tree_.add(build, std::move(played), state, fade);
  settled_at_ = build.now() + fade;
  retarget(build.as<Inertialiser>(inertialiser_), tree_.root(), left_.root(), half_life_of(fade));
}

bool StateMachineChannel::update_played(const EntityBuilder& build) {
  bool changed = false;
  for (std::size_t i = 0; i < tree_.count; ++i) changed = tree_.played[i].update(build) || changed;
  tree_.join(build);
  return changed;
}

Ticks StateMachineChannel::next_update() const {
  return inertialiser_.valid() ? Ticks{} : std::min(due_, tree_.next_update());
}

void StateMachineChannel::cut_fades(const EntityBuilder& build) {
  tree_.faded_at = build.now();
  tree_.end_fade(build);
  cut_interruption(build, inertialiser_, left_);
  settled_at_ = Ticks{};
}

void StateMachineChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  tree_.visit_handles(visit);
  left_.visit_handles(visit);
  if (inertialiser_.valid()) visit(inertialiser_);
}

void StateMachineChannel::destroy_entities(const EntityBuilder& build) {
  tree_.destroy(build);
  cut_interruption(build, inertialiser_, left_);
  settled_at_ = Ticks{};
}

}  // namespace throng::anim
