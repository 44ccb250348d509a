#include "app/commands/bench/report.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <vector>

#include "app/files/exit_status.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

std::string short_text(const Json& value) {
  if (value.is_null()) return "-";
  if (value.is<std::string>()) return value.get<std::string>();
  if (!value.is_float()) return value.dump();
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value.get<double>());
  return text;
}

/// Returns the heading of a column: its key without the word that all keys end in.
std::string column_heading(std::string_view key) {
  constexpr std::string_view all_have = "_median";
  if (key.ends_with(all_have)) key.remove_suffix(all_have.size());
  return std::string(key);
}

std::string lines_of(const Json& row) {
  std::string text;
  for (const auto& [key, value] : row.members()) {
    std::string line = key;
    line.resize(std::max<std::size_t>(34, key.size()), ' ');
    text += line + " " + value.dump() + "\n";
  }
  return text;
}

Status write(const BenchOptions& options, const Result<BenchReport>& report) {
  if (!report) return report.error();
  if (!options.plot.empty()) {
    Status written = write_whole_file(options.plot, report->plot);
    if (!written) return written;
  }
  if (!options.json.empty()) return write_output(options.json, report->json.dump(2) + "\n");
  return print(report->text);
}

}  // namespace

std::string figures_as_text(std::span<const Json> rows, std::span<const char* const> columns) {
  if (rows.size() == 1 && columns.empty()) return lines_of(rows.front());
  std::vector<std::vector<std::string>> cells(1);
  for (const char* const key : columns) cells.front().push_back(column_heading(key));
  for (const Json& row : rows) {
    cells.emplace_back();
    for (const char* const key : columns) cells.back().push_back(row.contains(key) ? short_text(row[key]) : "-");
  }
  std::string text;
  for (const std::vector<std::string>& line : cells) {
    for (std::size_t column = 0; column < line.size(); ++column) {
      std::size_t width = 0;
      for (const auto& other : cells) width = std::max(width, other[column].size());
      text += std::string(width - line[column].size() + (column == 0 ? 0 : 2), ' ') + line[column];
    }
    text += '\n';
  }
  return text;
}

Json figures_as_json(std::span<const Json> rows) {
  if (rows.size() == 1) return rows.front();
  return {{"rows", rows}};
}

int end_with_report(const BenchOptions& options, const Result<BenchReport>& report) {
  return end_with(write(options, report));
}

}  // namespace throng::app
