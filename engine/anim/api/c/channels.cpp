#include "engine/anim/api/c/parts.h"

using namespace throng::c;  // NOLINT: functions of C have no namespace

namespace {

throng_machine* keep(Result<StateMachine> made) {
  if (made) return make<throng_machine>(std::move(*made));
  fail(made.error().message);
  return nullptr;
}

}  // namespace

throng_machine* throng_machine_load(const char* path, const throng_character* character) {
  if (is_missing("throng_machine_load", path, character)) return nullptr;
  return keep(StateMachine::load(path, character->own));
}

throng_machine* throng_machine_parse(const char* json, const throng_character* character) {
  if (is_missing("throng_machine_parse", json, character)) return nullptr;
  return keep(StateMachine::parse(json, character->own));
}

void throng_machine_free(throng_machine* machine) { delete machine; }

uint32_t throng_machine_find_input(const throng_machine* machine, const char* name) {
  if (is_missing("throng_machine_find_input", machine, name)) return THRONG_NONE;
  return machine->own.find_input(name).value_or(THRONG_NONE);
}

const char* throng_machine_state_name(const throng_machine* machine, uint32_t state) {
  if (is_missing("throng_machine_state_name", machine)) return nullptr;
  const std::string_view name = machine->own.state_name(state);
  return name.empty() ? nullptr : name.data();  // it is a whole std::string
}

uint32_t throng_agent_add_slot(throng_crowd* crowd, throng_id agent) {
  if (is_missing("throng_agent_add_slot", crowd)) return THRONG_NONE;
  return number_or_none(agent_of(crowd, agent).add_slot());
}

int throng_agent_play_once(throng_crowd* crowd, throng_id agent, uint32_t slot, const throng_one_shot* shot) {
  const Call call("throng_agent_play_once");
  if (call.is_missing(crowd, shot)) return failed;
  return call.outcome(agent_of(crowd, agent)
                          .play_once({slot}, {.clip = {shot->clip},
                                              .fade_in = to_ticks(static_cast<double>(shot->fade_in)),
                                              .fade_out = to_ticks(static_cast<double>(shot->fade_out)),
                                              .speed = static_cast<double>(shot->speed),
                                              .queued = shot->queued != 0}));
}

int throng_agent_is_playing(const throng_crowd* crowd, throng_id agent, uint32_t slot) {
  const Call call("throng_agent_is_playing");
  if (call.is_missing(crowd)) return 0;
  const bool is_playing = agent_of(crowd, agent).is_playing({slot});
  return call.went_well() && is_playing ? 1 : 0;
}

uint32_t throng_agent_add_machine(throng_crowd* crowd, throng_id agent, const throng_machine* machine) {
  if (is_missing("throng_agent_add_machine", crowd, machine)) return THRONG_NONE;
  return number_or_none(agent_of(crowd, agent).add(machine->own));
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
