#include "engine/anim/agent/channel/state_machine_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/anim/agent/channel/machine_condition.h"
#include "engine/base/text/plain_text.h"

namespace throng::anim {
namespace {

using Description = MachineDescription;
using Kind = Description::Input::Kind;

std::string state_in_words(const std::string& name) { return "state " + in_quotes(name); }

std::string in_words(const Description::Transition& transition) {
  const std::string from = transition.from == Description::Transition::any ? "any state" : in_quotes(transition.from);
  return "the transition from " + from + " to " + in_quotes(transition.to);
}

template <typename Named>
bool has_twice(const std::vector<Named>& all, const std::string& name) {
  return std::ranges::count(all, name, &Named::name) > 1;
}

bool is_time(double seconds) { return seconds >= 0.0 && is_fade(to_ticks(seconds)); }

/// Lists the names of clips, as many as a line has room for.
std::string listed(const std::vector<BakedClip>& clips) {
  constexpr std::size_t most = 12;
  std::string names;
  std::size_t count = 0;
  for (const BakedClip& clip : clips) {
    if (clip.is_empty() || ++count > most) continue;
    names += (names.empty() ? "" : ", ") + clip.name;
  }
  return count > most ? names + " and " + std::to_string(count - most) + " more" : names;
}

}  // namespace

Result<std::shared_ptr<const StateMachine>> StateMachineBuilder::build() {
  using Step = Status (StateMachineBuilder::*)();
  for (const Step step : {&StateMachineBuilder::take_inputs, &StateMachineBuilder::take_states,
                          &StateMachineBuilder::take_start, &StateMachineBuilder::take_transitions}) {
    if (const Status taken = (this->*step)(); !taken) return taken.error();
  }
  if (const Status reached = check_reach(); !reached) return reached.error();
  if (const Status rests = check_rest(); !rests) return rests.error();
  return std::shared_ptr<const StateMachine>(machine_);
}

Status StateMachineBuilder::take_inputs() {
  const std::vector<Description::Input>& inputs = description_->inputs;
  if (inputs.size() > StateMachine::most_inputs) {
    return Error{"a state machine has at most " + std::to_string(StateMachine::most_inputs) + " inputs"};
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::string name = "input " + in_quotes(inputs[i].name);
    if (!is_input_name(inputs[i].name))
      return Error{name + " is named by letters, digits and underscores, and not \"not\""};
    if (has_twice(inputs, inputs[i].name)) return Error{name + " is there twice: give each a name of its own"};
    const auto value = static_cast<float>(inputs[i].value);
    if (!std::isfinite(value)) return Error{name + " begins with a finite number"};
    machine_->starting_inputs_[i] = value;
  }
  machine_->inputs_ = inputs;
  return Done{};
}

Status StateMachineBuilder::take_states() {
  const std::vector<Description::State>& states = description_->states;
  if (states.empty()) return Error{"a state machine has states: give it one"};
  if (states.size() > StateMachine::most_states) {
    return Error{"a state machine has at most " + std::to_string(StateMachine::most_states) + " states"};
  }
  for (const Description::State& state : states) {
    if (Status taken = take_state(state); !taken)
      return Error{state_in_words(state.name) + " " + taken.error().message};
  }
  return Done{};
}

Status StateMachineBuilder::take_state(const Description::State& from) {
  const bool is_name = !from.name.empty() && from.name != Description::Transition::any;
  if (!is_name) return Error{"needs another name: \"*\" means any state"};
  if (has_twice(description_->states, from.name)) return Error{"is there twice: give each a name of its own"};
  if (from.clip.empty() == from.points.empty()) return Error{"plays either a clip or points: give it one of the two"};
  StateMachine::State state{.name = from.name};
  if (Status taken = from.points.empty() ? take_clip(from, state) : take_space(from, state); !taken) return taken;
  machine_->states_.push_back(std::move(state));
  return Done{};
}

Result<int> StateMachineBuilder::clip_of(const std::string& name) const {
  const auto& clips = character_->clips;
  const auto is_named = [&](const BakedClip& clip) { return !clip.is_empty() && clip.name == name; };
  const auto found = std::ranges::find_if(clips, is_named);
  if (found != clips.end()) return static_cast<int>(found - clips.begin());
  return Error{"plays clip " + in_quotes(name) + ", which " + in_quotes(character_->skeleton.name) +
               " has not: choose one of " + listed(clips)};
}

Status StateMachineBuilder::take_clip(const Description::State& from, StateMachine::State& state) const {
  const Result<int> clip = clip_of(from.clip);
  if (!clip) return clip.error();
  if (!from.by.empty())
    return Error{"plays a clip, so nothing is blended by an input: give it points, or leave out \"by\""};
  if (!is_speed(from.speed)) return Error{std::string("has a speed out of range: ") + not_a_speed};
  const Ticks begin = from.speed < 0.0 ? character_->clips[static_cast<std::size_t>(*clip)].duration : Ticks{};
  state.clip = {.clip = *clip, .speed = from.speed, .start = begin, .loop = from.loop};
  return Done{};
}

Status StateMachineBuilder::take_space(const Description::State& from, StateMachine::State& state) const {
  if (Status taken = take_inputs_of_space(from, state); !taken) return taken;
  return from.by.size() == 1 ? take_points(from, state) : take_plane(from, state);
}

Status StateMachineBuilder::take_inputs_of_space(const Description::State& from, StateMachine::State& state) const {
  if (from.by.empty() || from.by.size() > state.by.size())
    return Error{"blends by one or two inputs: name them in \"by\""};
  for (std::size_t i = 0; i < std::min(from.by.size(), state.by.size()); ++i) {
    const std::optional<std::uint32_t> input = machine_->find_input(from.by[i]);
    if (!input || machine_->input(*input).kind != Kind::number) {
      return Error{"blends by " + in_quotes(from.by[i]) + ", which is no input that is a number: add one of this name"};
    }
    state.by[i] = static_cast<std::uint8_t>(*input);
  }
  return Done{};
}

Status StateMachineBuilder::take_points(const Description::State& from, StateMachine::State& state) const {
  const bool is_speed = from.meaning.empty() || from.meaning == "speed";
  if (!is_speed && from.meaning != "plain") {
    return Error{"says that its input means " + in_quotes(from.meaning) + ": one input is \"speed\" or \"plain\""};
  }
  std::vector<BlendPoint> points;
  for (const Description::Point& point : from.points) {
    const Result<int> clip = clip_of(point.clip);
    if (!clip) return clip.error();
    const auto at = static_cast<float>(point.at[0]);
    if (!std::isfinite(at)) return Error{"has a point at a place that is no number"};
    if (!points.empty() && !(points.back().parameter < at)) return Error{"has points out of order: let \"at\" ascend"};
    points.push_back({.clip = *clip, .parameter = at});
  }
  state.is_ground_speed = is_speed;
  state.points = std::make_shared<const std::vector<BlendPoint>>(std::move(points));
  return Done{};
}

Status StateMachineBuilder::take_plane(const Description::State& from, StateMachine::State& state) const {
  PlaneMeaning meaning = PlaneMeaning::velocity;
  if (from.meaning == "speed_and_turn") {
    meaning = PlaneMeaning::speed_and_turn;
  } else if (from.meaning == "plain") {
    meaning = PlaneMeaning::plain;
  } else if (!from.meaning.empty() && from.meaning != "velocity") {
    return Error{"says that its inputs mean " + in_quotes(from.meaning) +
                 ": two inputs are \"velocity\", \"speed_and_turn\" or \"plain\""};
  }
  std::vector<BlendPoint2d> points;
  for (const Description::Point& point : from.points) {
    const Result<int> clip = clip_of(point.clip);
    if (!clip) return clip.error();
    points.push_back({.clip = *clip, .place = {static_cast<float>(point.at[0]), static_cast<float>(point.at[1])}});
  }
  auto plane = BlendSpace2d::create(std::move(points), meaning, static_cast<int>(character_->clips.size()));
  if (!plane) return Error{"has points that make no plane: " + plane.error().message};
  state.plane = *plane;
  return Done{};
}

Status StateMachineBuilder::take_start() {
  const std::optional<std::uint32_t> start =
      description_->start.empty() ? std::optional<std::uint32_t>(0) : machine_->find_state(description_->start);
  if (!start)
    return Error{"it starts in " + in_quotes(description_->start) + ", which is no state: name one of its states"};
  machine_->start_ = static_cast<std::uint8_t>(*start);
  return Done{};
}

Status StateMachineBuilder::take_transitions() {
  const std::vector<Description::Transition>& transitions = description_->transitions;
  if (transitions.size() > StateMachine::most_transitions) {
    return Error{"a state machine has at most " + std::to_string(StateMachine::most_transitions) + " transitions"};
  }
  for (std::size_t i = 0; i < transitions.size(); ++i) {
    const Status taken = take_transition(transitions[i], static_cast<std::uint16_t>(i));
    if (!taken) return Error{in_words(transitions[i]) + " " + taken.error().message};
  }
  return Done{};
}

Status StateMachineBuilder::take_transition(const Description::Transition& from, std::uint16_t index) {
  const std::optional<std::uint32_t> to = machine_->find_state(from.to);
  if (!to) return Error{"leads to no state of this name: name one of the states"};
  StateMachine::Transition transition{.to = static_cast<std::uint8_t>(*to), .at_end = from.at_end};
  if (Status taken = take_times(from, transition); !taken) return taken;
  for (const std::string& text : from.when) {
    const Result<StateMachine::Condition> condition = read_condition(text, machine_->inputs_);
    if (!condition) return Error{"has a condition, " + in_quotes(text) + ", which " + condition.error().message};
    transition.when.push_back(*condition);
  }
  if (Status checked = check_source(from, transition); !checked) return checked;
  const bool from_any = from.from == Description::Transition::any;
  for (StateMachine::State& state : machine_->states_) {
    const bool leads_from = from_any ? state.name != from.to : state.name == from.from;
    if (leads_from) state.transitions.push_back(index);
  }
  machine_->transitions_.push_back(std::move(transition));
  return Done{};
}

Status StateMachineBuilder::take_times(const Description::Transition& from,
                                       StateMachine::Transition& transition) const {
  if (!is_time(from.after) || !is_time(from.fade)) return Error{"takes times from 0 to 86,400 seconds"};
  transition.after = to_ticks(from.after);
  transition.fade = to_ticks(from.fade);
  return Done{};
}

Status StateMachineBuilder::check_source(const Description::Transition& from,
                                         const StateMachine::Transition& transition) const {
  if (from.from == Description::Transition::any) {
    return from.at_end ? Status(Error{"waits for the end of a clip, so it leads from one state: name that"}) : Done{};
  }
  const std::optional<std::uint32_t> source = machine_->find_state(from.from);
  if (!source) return Error{"leads from no state of this name: name one of the states, or \"*\" for any"};
  const StateMachine::State& state = machine_->states_[*source];
  const bool has_end = !state.is_blend_space() && std::abs(state.clip.speed) >= slowest_speed;
  if (from.at_end && !has_end) return Error{"waits for an end that never comes: give it \"when\" or \"after\""};
  const bool at_once = transition.when.empty() && !from.at_end && transition.after <= Ticks{};
  if (at_once && *source == transition.to) return Error{"begins its state anew at once, forever: give it a condition"};
  return Done{};
}

// Follows all transitions from the start.
Status StateMachineBuilder::check_reach() const {
  std::vector<bool> reached(machine_->states_.size());
  std::vector<std::uint8_t> next{machine_->start_};
  reached[machine_->start_] = true;
  while (!next.empty()) {
    const StateMachine::State& state = machine_->states_[next.back()];
    next.pop_back();
    for (const std::uint16_t transition : state.transitions) {
      const std::uint8_t to = machine_->transitions_[transition].to;
      if (!reached[to]) next.push_back(to);
      reached[to] = true;
    }
  }
  const auto lost = std::ranges::find(reached, false);
  if (lost == reached.end()) return Done{};
  const std::string& name = machine_->states_[static_cast<std::size_t>(lost - reached.begin())].name;
  return Error{state_in_words(name) + " is never reached from " + in_quotes(machine_->states_[machine_->start_].name) +
               ": add a transition that leads to it, or leave it out"};
}

// Follows, from each state, the transition that is taken as soon as the state is entered, whatever the inputs are.
Status StateMachineBuilder::check_rest() const {
  const auto leaves_at_once = [&](std::uint16_t index) {
    const StateMachine::Transition& transition = machine_->transitions_[index];
    return transition.when.empty() && !transition.at_end && transition.after <= Ticks{};
  };
  for (std::size_t first = 0; first < machine_->states_.size(); ++first) {
    std::size_t at = first;
    for (std::size_t hops = 0; hops < machine_->states_.size(); ++hops) {
      const auto& leading = machine_->states_[at].transitions;
      const auto found = std::ranges::find_if(leading, leaves_at_once);
      if (found == leading.end()) break;
      at = machine_->transitions_[*found].to;
      if (at != first) continue;
      return Error{state_in_words(machine_->states_[first].name) +
                   " leads back to itself at once, forever: give a transition on the way a condition"};
    }
  }
  return Done{};
}

}  // namespace throng::anim
