#include "engine/anim/api/c/parts.h"

using namespace throng::c;  // NOLINT: functions of C have no namespace

throng_machine* throng_machine_load(const char* path, const throng_character* character) {
  if (is_missing("throng_machine_load", path, character)) return nullptr;
  return make_of<throng_machine>(StateMachine::load(path, character->own));
}

throng_machine* throng_machine_parse(const char* json, const throng_character* character) {
  if (is_missing("throng_machine_parse", json, character)) return nullptr;
  return make_of<throng_machine>(StateMachine::parse(json, character->own));
}

void throng_machine_free(throng_machine* machine) { delete machine; }

uint32_t throng_machine_find_input(const throng_machine* machine, const char* name) {
  if (is_missing("throng_machine_find_input", machine, name)) return THRONG_NONE;
  return machine->own.find_input(name).value_or(THRONG_NONE);
}

uint32_t throng_machine_find_state(const throng_machine* machine, const char* name) {
  if (is_missing("throng_machine_find_state", machine, name)) return THRONG_NONE;
  return machine->own.find_state(name).value_or(THRONG_NONE);
}

const char* throng_machine_state_name(const throng_machine* machine, uint32_t state) {
  if (is_missing("throng_machine_state_name", machine)) return nullptr;
  return text_of(machine->own.state_name(state));
}

uint32_t throng_agent_add_machine(throng_crowd* crowd, throng_id agent, const throng_machine* machine,
                                  const throng_layer* layer) {
  const Call call("throng_agent_add_machine");
  if (call.is_missing(crowd, machine)) return THRONG_NONE;
  const auto read = call.read("throng_layer", layer);
  if (!read) return THRONG_NONE;
  return number_or_none(agent_of(crowd, agent).add(machine->own, Layer{.weight = read->weight, .mask = {read->mask}}));
}

int throng_agent_set_input(throng_crowd* crowd, throng_id agent, uint32_t channel, uint32_t input, float value) {
  const Call call("throng_agent_set_input");
  if (call.is_missing(crowd)) return failed;
  return call.outcome(Machine(agent_of(crowd, agent), {channel}).set(input, value));
}

uint32_t throng_agent_state(throng_crowd* crowd, throng_id agent, uint32_t channel) {
  const Call call("throng_agent_state");
  if (call.is_missing(crowd)) return THRONG_NONE;
  const uint32_t state = Machine(agent_of(crowd, agent), {channel}).state();
  return call.went_well() ? state : THRONG_NONE;
}

double throng_agent_state_entered_at(throng_crowd* crowd, throng_id agent, uint32_t channel) {
  const Call call("throng_agent_state_entered_at");
  if (call.is_missing(crowd)) return 0.0;
  return call.answer(to_seconds(Machine(agent_of(crowd, agent), {channel}).entered_at()));
}
