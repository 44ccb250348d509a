#pragma once

#include <vector>

#include "app/character/cast_entry.h"
#include "app/settings/option_values.h"

namespace throng::app {

/// Reads ENTRY[*SHARE][,ENTRY[*SHARE]...]; an entry is a file, FILE#SKIN, or a folder. A file whose own name ends like
/// a share goes first.
ValueReader cast_entries(std::vector<CastEntry>& target);

/// Reads entries of cast_entries(), or the name of a file of rules, which ends in .json.
ValueReader cast_or_rules(std::vector<CastEntry>& target, std::string& rules);

}  // namespace throng::app
