#include "app/commands/bench/command.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/bench/drawing.h"
#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/turns.h"
#include "app/files/exit_status.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

using Rows = std::vector<Json>;

constexpr std::array columns = {"agents",
                                "bones_per_agent",
                                "clips",
                                "pus",
                                "schedule",
                                "stream",
                                "tile",
                                "ns_per_bone_median",
                                "kernels_ns_per_bone_median",
                                "write_floor_ns_per_bone_median",
                                "speedup_over_one_pu",
                                "ns_per_bone_over_first_row",
                                "agents_per_60hz_frame",
                                "bytes_per_agent"};

std::string plot_of_one(const Json& row) {
  constexpr std::array<std::pair<const char*, const char*>, 6> subjects = {
      {{"write_floor_ns_per_bone_median", "writing palettes alone"},
       {"kernels_ns_per_bone_median", "kernels, one thread"},
       {"one_pu_ns_per_bone_median", "update, one PU"},
       {"ns_per_bone_median", "update, all PUs"},
       {"keyframe_ns_per_bone_median", "update, exact keys"},
       {"scalar_ns_per_bone_median", "kernels without vectors"}}};
  std::vector<PlotBar> bars;
  for (const auto& [key, name] : subjects) {
    if (row[key].is_number())
      bars.push_back({name, row[key].get<double>(), key == std::string_view("ns_per_bone_median")});
  }
  return bars_as_svg(row["agents"].dump() + " agents of " + row["bones_per_agent"].dump() + " bones, " +
                         row["clips"].dump() + " clips",
                     "ns a bone", bars);
}

/// Names a row by the values that differ between rows and are not on the axis.
std::string line_name(const Json& row, const Rows& rows, const std::string& axis) {
  std::string name;
  for (const char* const key : {"agents", "bones_per_agent", "clips", "pus", "schedule", "stream"}) {
    const bool varies = std::ranges::any_of(rows, [&](const Json& other) { return other[key] != row[key]; });
    if (!varies || key == axis) continue;
    const std::string value = row[key].is<std::string>() ? row[key].get<std::string>() : row[key].dump() + " " + key;
    name += (name.empty() ? "" : ", ") + value;
  }
  return name.empty() ? "update" : name;
}

std::string plot_of_table(const Rows& rows) {
  std::string axis = "agents";
  for (const char* const key : {"pus", "clips", "bones_per_agent", "agents"}) {
    if (std::ranges::any_of(rows, [&](const Json& row) { return row[key] != rows.front()[key]; })) axis = key;
  }
  std::vector<PlotLine> lines;
  const auto add = [&](const std::string& name, const Json& row, const char* figure, bool dashed) {
    if (!row[figure].is_number()) return;
    auto line = std::ranges::find(lines, name, &PlotLine::name);
    if (line == lines.end()) line = lines.insert(lines.end(), {.name = name, .x = {}, .y = {}, .dashed = dashed});
    line->x.push_back(row[axis].get<double>());
    line->y.push_back(row[figure].get<double>());
  };
  for (const Json& row : rows) add(line_name(row, rows, axis), row, "ns_per_bone_median", false);
  if (lines.size() == 1) {
    for (const Json& row : rows) add("kernels, one thread", row, "kernels_ns_per_bone_median", true);
    for (const Json& row : rows) add("writing palettes alone", row, "write_floor_ns_per_bone_median", true);
  }
  return lines_as_svg("What an update costs", axis == "bones_per_agent" ? "bones" : axis, "ns a bone", lines);
}

int run_table(const BenchOptions& options) {
  Rows rows;
  std::optional<TimelineLog> trace;
  if (!options.trace.empty()) trace.emplace();
  if (const auto ended = run_cases(options, rows, trace)) return *ended;
  if (trace) {
    const Status written = write_whole_file(options.trace, trace->to_json());
    if (!written) return end_with(written);
  }
  const bool one = rows.size() == 1;
  BenchReport report{.text = one ? figures_as_text(rows, {}) : figures_as_text(rows, columns),
                     .json = figures_as_json(rows),
                     .plot = {}};
  if (!options.plot.empty()) report.plot = one ? plot_of_one(rows.front()) : plot_of_table(rows);
  return end_with_report(options, report);
}

}  // namespace

int run_bench(const BenchOptions& options) {
  if (options.draws) return end_with_report(options, measure_drawing(options));
  return run_table(options);
}

}  // namespace throng::app
