#pragma once

#include <span>
#include <string>

#include "app/commands/bench/command.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// The figures of a measurement, for a person, for programs, and drawn (empty: there is nothing to draw).
struct BenchReport {
  std::string text;
  Json json;
  std::string plot;
};

/// Writes a report to where the options say, or the sentence of its error. Returns the exit status.
int end_with_report(const BenchOptions& options, const Result<BenchReport>& report);

/// Writes flat objects of equal keys as text for a person: one object as lines of key and value, several as a table of
/// the keys in `columns` with numbers of four digits.
std::string figures_as_text(std::span<const Json> rows, std::span<const char* const> columns);

/// Returns one object as it is, and several as `{"rows": [...]}`.
Json figures_as_json(std::span<const Json> rows);

}  // namespace throng::app
