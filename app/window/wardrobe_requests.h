#pragma once

#include <string>

#include "app/show/request/request.h"
#include "engine/base/result.h"

namespace throng::app {

class Stage;

/// Returns the request for a character's rules with other values.
SetRules tuned(const TuneRules& asked, const Stage& stage);

/// Writes the rules in force as NAME.cast.json in the working folder; they come from that file then. Errors: those of
/// write_cast_rules().
Result<SetRules> saved(const SaveRules& asked, const Stage& stage, CharacterNumber character);
/// Reads the rules of NAME.cast.json; without a name the file in force. Errors: those of read_cast_rules().
Result<SetRules> loaded(const LoadRules& asked, const Stage& stage, CharacterNumber character);

}  // namespace throng::app
