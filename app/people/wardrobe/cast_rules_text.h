#pragma once

#include <filesystem>
#include <string>

#include "app/people/wardrobe/cast_rules.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// Returns the JSON that cast_rules() reads as the same rules.
Json to_json(const CastRules& rules);

/// Returns rules as one line, and reads them; an empty text is rules without styles. The error is the end of a
/// sentence.
std::string rules_text(const CastRules& rules);
Result<CastRules> rules_of_text(const std::string& text);

/// Writes rules for people to edit, whole or not at all. The error names the file.
Status write_cast_rules(const std::filesystem::path& file, const CastRules& rules);

}  // namespace throng::app
