#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace throng::app {

/// Flat objects of equal keys as text for a person: one as lines of key and value; several as a table of the keys in
/// `columns`, numbers rounded to four digits.
std::string figures_as_text(std::span<const nlohmann::ordered_json> rows, std::span<const char* const> columns);

/// One object as it is; several as `{"rows": [...]}`.
nlohmann::ordered_json figures_as_json(std::span<const nlohmann::ordered_json> rows);

}  // namespace throng::app
