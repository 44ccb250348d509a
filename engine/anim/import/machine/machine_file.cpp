#include "engine/anim/import/machine/machine_file.h"

#include <optional>

#include "engine/base/files/input_file.h"
#include "engine/base/json/json_object.h"

namespace throng::import {
namespace {

using anim::MachineDescription;

using Complaint = std::optional<std::string>;

std::string numbered(std::string_view what, std::size_t index) { return std::string(what) + std::to_string(index); }

MachineDescription::Input input_of(const Json& json, std::size_t index, Complaint& complaint) {
  const JsonObject reader(numbered("input ", index), json, {"name", "value", "trigger"}, complaint);
  MachineDescription::Input input;
  reader.text("name", input.name);
  bool is_trigger = false;
  reader.flag("trigger", is_trigger);
  const Json& value = reader["value"];
  using Kind = MachineDescription::Input::Kind;
  if (is_trigger) input.kind = Kind::trigger;
  if (value.is<bool>()) {
    input.kind = is_trigger ? Kind::trigger : Kind::flag;
    input.value = value.get<bool>() ? 1.0 : 0.0;
  } else if (is_trigger && !value.is_null()) {
    reader.wrong("value", "true or false for a trigger");
  } else {
    reader.read("value", input.value, "a number, true or false");
  }
  return input;
}

/// Reads the one or two numbers of a point.
MachineDescription::Point point_of(const JsonObject& reader, std::size_t inputs) {
  MachineDescription::Point point;
  reader.text("clip", point.clip);
  const Json& at = reader["at"];
  if (inputs < 2) {
    if (!at.is_number()) reader.wrong("at", "a number");
    if (at.is_number()) point.at[0] = at.get<double>();
  } else if (at.is<std::vector<double>>() && at.elements().size() == 2) {
    for (std::size_t axis = 0; axis < 2; ++axis) point.at[axis] = at.elements()[axis].get<double>();
  } else {
    reader.wrong("at", "an array of two numbers");
  }
  return point;
}

MachineDescription::State state_of(const Json& json, std::size_t index, Complaint& complaint) {
  const std::string name = numbered("state ", index);
  const JsonObject reader(name, json, {"name", "clip", "speed", "loop", "by", "points", "meaning"}, complaint);
  MachineDescription::State state;
  reader.text("name", state.name);
  reader.text("clip", state.clip);
  reader.number("speed", state.speed);
  reader.flag("loop", state.loop);
  reader.text("meaning", state.meaning);
  if (reader["by"].is<std::string>()) {
    state.by = {reader["by"].get<std::string>()};
  } else {
    reader.read("by", state.by, "the name of an input, or an array of two");
  }
  for (const Json& point : reader.elements("points")) {
    const std::string point_name = name + ", point " + std::to_string(state.points.size());
    state.points.push_back(point_of(JsonObject(point_name, point, {"clip", "at"}, complaint), state.by.size()));
  }
  return state;
}

MachineDescription::Transition transition_of(const Json& json, std::size_t index, Complaint& complaint) {
  const JsonObject reader(numbered("transition ", index), json, {"from", "to", "when", "after", "at_end", "fade"},
                          complaint);
  MachineDescription::Transition transition;
  reader.text("from", transition.from);
  reader.text("to", transition.to);
  reader.texts("when", transition.when);
  reader.number("after", transition.after);
  reader.flag("at_end", transition.at_end);
  reader.number("fade", transition.fade);
  return transition;
}

MachineDescription machine_of(const Json& json, Complaint& complaint) {
  const JsonObject reader("a state machine", json, {"inputs", "start", "states", "transitions"}, complaint);
  MachineDescription machine;
  reader.text("start", machine.start);
  for (const Json& input : reader.elements("inputs")) {
    machine.inputs.push_back(input_of(input, machine.inputs.size(), complaint));
  }
  for (const Json& state : reader.elements("states")) {
    machine.states.push_back(state_of(state, machine.states.size(), complaint));
  }
  for (const Json& transition : reader.elements("transitions")) {
    machine.transitions.push_back(transition_of(transition, machine.transitions.size(), complaint));
  }
  return machine;
}

}  // namespace

Result<MachineDescription> read_machine(std::string_view text) {
  const Result<Json> json = throng::parse_json(text);
  if (!json) return Error{"it " + json.error().message};
  Complaint complaint;
  MachineDescription machine = machine_of(*json, complaint);
  if (complaint) return Error{*complaint};
  return machine;
}

Result<MachineDescription> read_machine_file(const std::string& path) {
  const auto text = read_text(path, "a .json", most_json_bytes);
  auto machine = text ? read_machine(*text) : text.error();
  if (!machine) return Error{path + ": " + machine.error().message};
  return machine;
}

}  // namespace throng::import
