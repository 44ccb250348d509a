#pragma once

#include <string>
#include <string_view>

#include "engine/anim/asset/machine_description.h"
#include "engine/base/result.h"

namespace throng::import {

/// Reads a state machine:
///
///     {
///       "inputs": [ {"name": "speed", "value": 0},
///                   {"name": "grounded", "value": true},
///                   {"name": "jump", "trigger": true} ],
///       "start": "move",
///       "states": [ {"name": "move", "by": "speed", "points": [ {"clip": "idle", "at": 0}, {"clip": "run", "at": 3.6}
///       ]},
///                   {"name": "jump", "clip": "jump", "loop": false} ],
///       "transitions": [ {"from": "move", "to": "jump", "when": ["jump", "grounded"], "fade": 0.1},
///                        {"from": "jump", "to": "move", "at_end": true, "fade": 0.2} ]
///     }
///
/// MachineDescription says what each member means; members with a default may be left out. "by" and "at" are one of
/// each, or an array of two. The error is a sentence with the object and the key. Only names are left to be checked, by
/// StateMachine::create.
Result<anim::MachineDescription> read_machine(std::string_view text);

/// Reads such a file. Errors begin with its name.
Result<anim::MachineDescription> read_machine_file(const std::string& path);

}  // namespace throng::import
