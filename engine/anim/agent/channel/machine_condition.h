#pragma once

#include <span>
#include <string>

#include "engine/anim/agent/channel/state_machine.h"

namespace throng::anim {

/// Reads a condition: "speed > 1.5" with <, <=, > or >= for a number; "grounded" or "not grounded" for a flag; "jump"
/// for a trigger. The error is the end of a sentence that begins with the text.
Result<StateMachine::Condition> read_condition(const std::string& text,
                                               std::span<const MachineDescription::Input> inputs);

/// Returns whether an input may have this name: letters, digits and underscores, and not "not".
bool is_input_name(std::string_view name);

}  // namespace throng::anim
