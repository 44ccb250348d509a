#include "throng/state_machine.h"

#include <memory>
#include <utility>

#include "engine/anim/agent/channel/state_machine_channel.h"
#include "engine/anim/api/character_data.h"
#include "engine/anim/api/convert.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/api/machine_data.h"

#if defined(THRONG_HAS_IMPORT)
#include "engine/anim/import/machine/machine_file.h"
#endif

namespace throng {
namespace {

#if defined(THRONG_HAS_IMPORT)
Result<StateMachine> made_for(const anim::MachineDescription& description, const Character& character) {
  if (!character) return anim::refuse({"StateMachine", "the character is empty"});
  const anim::Character& baked = *character.data()->baked;
  auto machine = anim::StateMachine::create(description, baked);
  if (!machine) return machine.error();
  detail::MachineData data{.machine = std::move(*machine), .clips = {}, .names = {}};
  data.machine->for_each_clip([&](int clip) {
    data.clips.push_back(detail::id_of(baked, static_cast<std::uint32_t>(clip)));
    data.names.push_back(baked.clips[static_cast<std::size_t>(clip)].name);
  });
  return StateMachine(std::make_shared<const detail::MachineData>(std::move(data)));
}
#else
Error no_json() { return {"this build of the library reads no JSON: build it with throng::import"}; }
#endif

const anim::StateMachineChannel* playing(detail::CrowdParts& crowd, AgentId id, ChannelId channel) {
  anim::Agent agent = crowd.system->agent(id);
  const auto* const own = agent.channel<anim::StateMachineChannel>(channel);
  if (own == nullptr) {
    anim::report_misuse({"Machine", "the agent has no state machine of this id"});
    return nullptr;
  }
  if (own->next_update() > crowd.system->clock()) return own;
  static_cast<void>(agent.change<anim::StateMachineChannel>(channel, [](auto&) {}));
  return own;
}

}  // namespace

#if defined(THRONG_HAS_IMPORT)
Result<StateMachine> StateMachine::parse(std::string_view json, const Character& character) {
  const auto description = import::read_machine(json);
  return description ? made_for(*description, character) : Result<StateMachine>(description.error());
}

Result<StateMachine> StateMachine::load(const std::string& path, const Character& character) {
  const auto description = import::read_machine_file(path);
  if (!description) return description.error();
  Result<StateMachine> made = made_for(*description, character);
  if (!made) return Error{path + ": " + made.error().message};
  return made;
}
#else
Result<StateMachine> StateMachine::parse(std::string_view, const Character&) { return no_json(); }

Result<StateMachine> StateMachine::load(const std::string& path, const Character&) {
  return Error{path + ": " + no_json().message};
}
#endif

std::optional<std::uint32_t> StateMachine::find_input(std::string_view name) const {
  return data_ == nullptr ? std::nullopt : data_->machine->find_input(name);
}

std::optional<std::uint32_t> StateMachine::find_state(std::string_view name) const {
  return data_ == nullptr ? std::nullopt : data_->machine->find_state(name);
}

std::string_view StateMachine::state_name(std::uint32_t state) const {
  if (data_ == nullptr || state >= data_->machine->states().size()) return {};
  return data_->machine->states()[state].name;
}

bool Machine::set(std::uint32_t input, float value) const {
  bool taken = false;
  const auto change = [&](anim::StateMachineChannel& own) { taken = own.set(input, value); };
  return crowd_->system->agent(agent_)
             .change<anim::StateMachineChannel>(channel_, change, "Machine::set")
             .has_value() &&
         taken;
}

std::uint32_t Machine::state() const {
  const anim::StateMachineChannel* const own = playing(*crowd_, agent_, channel_);
  return own == nullptr ? 0 : own->current();
}

Ticks Machine::entered_at() const {
  const anim::StateMachineChannel* const own = playing(*crowd_, agent_, channel_);
  return own == nullptr ? Ticks{} : own->entered_at();
}

}  // namespace throng
