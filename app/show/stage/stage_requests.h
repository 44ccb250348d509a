#pragma once

#include "app/show/request/request.h"
#include "engine/base/result.h"

/// Requests that a stage carries out alone, without files and without the painter. Errors: they cannot be; then
/// nothing has changed.
namespace throng::app {

class Stage;

anim::Status carry_out(const SetShare& share, Stage& stage);
anim::Status carry_out(const SetRoles& roles, Stage& stage);
anim::Status carry_out(const SetRules& rules, Stage& stage);
anim::Status carry_out(const Select& select, Stage& stage);
anim::Status carry_out(const Push& push, Stage& stage);
anim::Status carry_out(const Hold& hold, Stage& stage);
anim::Status carry_out(const Seek& seek, Stage& stage);

/// Returns whether a stage has a character, or an agent. The error says which there are.
anim::Status has_character(const Stage& stage, CharacterNumber character);
anim::Status has_agent(const Stage& stage, std::uint32_t agent);

}  // namespace throng::app
