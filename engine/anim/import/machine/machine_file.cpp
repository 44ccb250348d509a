#include "engine/anim/import/machine/machine_file.h"

#include <initializer_list>
#include <utility>

#include "engine/anim/base/plain_text.h"
#include "engine/anim/import/json/json.h"
#include "engine/anim/import/refusal.h"
#include "engine/anim/import/source_file.h"

namespace throng::import {
namespace {

using anim::MachineDescription;

/// One object of the text, and its name in words. Each function throws Refusal.
class Reader {
 public:
  Reader(std::string name, const Json& object, std::initializer_list<std::string_view> keys)
      : name_(std::move(name)), object_(&object) {
    if (!object.is_object()) throw Refusal(name_ + " must be an object");
    const Json::Member* const other = object.member_beside(keys);
    if (other == nullptr) return;
    std::string known;
    for (const std::string_view key : keys) known.append(known.empty() ? "" : ", ").append(key);
    throw Refusal(name_ + " has an unknown key " + anim::in_quotes(other->key) + "; it knows " + known);
  }

  const Json& operator[](std::string_view key) const { return (*object_)[key]; }

  /// Reads a member into `value`, which keeps its default where there is none.
  template <typename T>
  void read(std::string_view key, T& value, std::string_view what) const {
    if (!object_->contains(key)) return;
    if (!(*this)[key].is<T>()) refuse(key, what);
    value = (*this)[key].get<T>();
  }
  void text(std::string_view key, std::string& value) const { read(key, value, "a text"); }
  void number(std::string_view key, double& value) const { read(key, value, "a number"); }
  void flag(std::string_view key, bool& value) const { read(key, value, "true or false"); }

  /// Returns the objects of an array; none where there is no array.
  std::span<const Json> objects(std::string_view key) const {
    if (object_->contains(key) && !(*this)[key].is_array()) refuse(key, "an array");
    return (*this)[key].elements();
  }
  [[noreturn]] void refuse(std::string_view key, std::string_view what) const {
    throw Refusal(name_ + ": \"" + std::string(key) + "\" must be " + std::string(what));
  }

 private:
  std::string name_;
  const Json* object_;
};

std::string numbered(std::string_view what, std::size_t index) { return std::string(what) + std::to_string(index); }

MachineDescription::Input input_of(const Json& json, std::size_t index) {
  const Reader reader(numbered("input ", index), json, {"name", "value", "trigger"});
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
    reader.refuse("value", "true or false for a trigger");
  } else {
    reader.read("value", input.value, "a number, true or false");
  }
  return input;
}

/// Reads the one or two numbers of a point.
MachineDescription::Point point_of(const std::string& state, const Json& json, std::size_t index, std::size_t inputs) {
  const Reader reader(state + ", point " + std::to_string(index), json, {"clip", "at"});
  MachineDescription::Point point;
  reader.text("clip", point.clip);
  const Json& at = reader["at"];
  if (inputs < 2) {
    if (!at.is_number()) reader.refuse("at", "a number");
    point.at[0] = at.get<double>();
  } else {
    if (!at.is<std::vector<double>>() || at.elements().size() != 2) reader.refuse("at", "an array of two numbers");
    for (std::size_t axis = 0; axis < 2; ++axis) point.at[axis] = at.elements()[axis].get<double>();
  }
  return point;
}

MachineDescription::State state_of(const Json& json, std::size_t index) {
  const std::string name = numbered("state ", index);
  const Reader reader(name, json, {"name", "clip", "speed", "loop", "by", "points", "meaning"});
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
  for (const Json& point : reader.objects("points")) {
    state.points.push_back(point_of(name, point, state.points.size(), state.by.size()));
  }
  return state;
}

MachineDescription::Transition transition_of(const Json& json, std::size_t index) {
  const Reader reader(numbered("transition ", index), json, {"from", "to", "when", "after", "at_end", "fade"});
  MachineDescription::Transition transition;
  reader.text("from", transition.from);
  reader.text("to", transition.to);
  reader.read("when", transition.when, "an array of texts");
  reader.number("after", transition.after);
  reader.flag("at_end", transition.at_end);
  reader.number("fade", transition.fade);
  return transition;
}

MachineDescription machine_of(const Json& json) {
  const Reader reader("a state machine", json, {"inputs", "start", "states", "transitions"});
  MachineDescription machine;
  reader.text("start", machine.start);
  for (const Json& input : reader.objects("inputs")) machine.inputs.push_back(input_of(input, machine.inputs.size()));
  for (const Json& state : reader.objects("states")) machine.states.push_back(state_of(state, machine.states.size()));
  for (const Json& transition : reader.objects("transitions")) {
    machine.transitions.push_back(transition_of(transition, machine.transitions.size()));
  }
  return machine;
}

}  // namespace

anim::Result<MachineDescription> read_machine(std::string_view text) {
  const Result<Json> json = parse_json(text);
  if (!json) return Error{"it " + json.error().message};
  try {
    return machine_of(*json);
  } catch (const Refusal& refusal) {
    return Error{refusal.what()};
  }
}

anim::Result<MachineDescription> read_machine_file(const std::string& path) {
  try {
    const std::vector<std::byte> bytes = read_file(path, "a .json", most_json_bytes);
    auto machine = read_machine({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!machine) return Error{path + ": " + machine.error().message};
    return machine;
  } catch (const Refusal& refusal) {
    return Error{path + ": " + refusal.what()};
  }
}

}  // namespace throng::import
