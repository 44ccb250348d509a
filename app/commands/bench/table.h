#pragma once

#include <span>
#include <string>

#include "engine/base/json/json.h"

namespace throng::app {

/// Writes flat objects of equal keys as text for a person: one object as lines of key and value, several as a table of
/// the keys in `columns` with numbers of four digits.
std::string figures_as_text(std::span<const Json> rows, std::span<const char* const> columns);

/// Returns one object as it is, and several as `{"rows": [...]}`.
Json figures_as_json(std::span<const Json> rows);

}  // namespace throng::app
