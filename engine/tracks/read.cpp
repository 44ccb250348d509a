#include "engine/tracks/read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include <glm/common.hpp>

#include "engine/base/files/input_file.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/doubts.h"
#include "engine/tracks/fcd_xml.h"
#include "engine/tracks/ground_bounds.h"
#include "engine/tracks/json_records.h"
#include "engine/tracks/raw_rows.h"
#include "engine/tracks/sqlite_file.h"
#include "engine/tracks/text/xml_text.h"
#include "engine/tracks/text_format.h"
#include "engine/tracks/text_rows.h"
#include "engine/tracks/tracks.h"
#include "engine/tracks/vadere_plan.h"

namespace throng {
namespace {

std::size_t count_rows(const RawTracks& tracks) {
  std::size_t count = 0;
  for (const RowBlock& block : tracks.blocks) count += block.rows.size();
  return count;
}

Result<VadereScenario> scenario_in(const std::string& file) {
  const auto text = read_text(file, "a scenario", most_json_bytes);
  if (!text) return text.error();
  const auto json = parse_json(*text);
  if (!json) return Error{"its text " + json.error().message};
  return vadere_scenario(*json);
}

/// Takes the obstacles, and the length of a step where rows have steps, of the scenario beside a file of Vadere.
void take_scenario(const std::string& file, const TrackReading& options, RawTracks& tracks) {
  if (tracks.facts.has_frames) tracks.facts.rate = 1.0 / VadereScenario{}.seconds_a_step;
  const auto scenario_file = scenario_beside(file);
  if (!scenario_file) return;
  auto scenario = scenario_in(*scenario_file);
  if (!scenario) {
    tracks.facts.remarks.push_back(*scenario_file + " is left out: " + scenario.error().message +
                                   "; --walls gives the place.");
    return;
  }
  if (tracks.facts.has_frames) tracks.facts.rate = 1.0 / scenario->seconds_a_step;
  if (!options.walls.empty()) return;
  tracks.plan = std::move(scenario->plan);
  tracks.facts.remarks.push_back("The place is that of " + *scenario_file + ".");
}

Status read_text_rows(const std::string& file, std::string_view head, const TrackReading& options,
                      const ReadProgress& progress, RawTracks& tracks) {
  if (head.size() >= head_bytes && head.find('\n') == std::string_view::npos && why_no_text(head).empty()) {
    return Error{file + ": line 1: it is longer than 64 KiB; name a file with a row a line"};
  }
  auto format = text_format_of(head);
  if (!format) return Error{file + ": " + format.error().message};
  tracks.facts = format->facts;
  Status read = read_rows(file, *format, options, progress, tracks);
  if (read && format->otherwise != nullptr && count_rows(tracks) == 0 && tracks.bad_rows == 0) {
    format->parser = std::move(format->otherwise);
    tracks.facts.format += " of vehicles";
    tracks.tables.clear();
    read = read_rows(file, *format, options, progress, tracks);
  }
  if (read && tracks.facts.format == "Vadere") take_scenario(file, options, tracks);
  return read;
}

Status read_raw(const std::string& file, const TrackReading& options, const ReadProgress& progress, RawTracks& tracks) {
  const auto head = read_head(file);
  if (!head) return head.error();
  if (is_sqlite(*head)) return read_sqlite(file, options, progress, tracks);
  if (is_xml(*head)) return read_fcd_xml(file, options, progress, tracks);
  if (is_json_document(*head)) return read_json_records(file, options, tracks);
  return read_text_rows(file, *head, options, progress, tracks);
}

/// The width of a plan in its units; 0 of an empty one.
double width_of(const FilePlan& plan) {
  glm::dvec2 least(1e300), most(-1e300);
  for_points(plan, [&](const glm::dvec2& point) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  });
  return std::max({most.x - least.x, most.y - least.y, 0.0});
}

/// Walls of a separate file may have another unit than the rows: the unit in which they are about as wide.
double unit_of_walls(const FilePlan& plan, Trajectories& tracks) {
  const double people = std::max(static_cast<double>(width_of(bounds_of(tracks))), 1.0), walls = width_of(plan);
  double best = 1.0;
  const auto misfit = [&](double unit) { return walls > 0.0 ? std::abs(std::log(walls * unit / people)) : 0.0; };
  for (const double unit : std::array{0.01, 0.001}) {
    if (misfit(unit) + 1.0 < misfit(best)) best = unit;
  }
  if (best < 1.0) {
    tracks.remarks.push_back(std::string("Walls are taken as ") + (best < 0.005 ? "millimetres" : "centimetres") +
                             ", for so they are about as wide as the crowd.");
  }
  return best;
}

}  // namespace

Result<Trajectories> read_trajectories(const std::string& file, const TrackReading& options,
                                       const ReadProgress& progress) {
  Result<FilePlan> walls = FilePlan{};
  if (!options.walls.empty()) walls = read_file_plan(options.walls);
  if (!walls) return walls.error();
  RawTracks raw;
  if (const Status read = read_raw(file, options, progress, raw); !read) return read.error();
  const auto beside = options.walls.empty() && raw.plan.is_empty() ? plan_beside(file) : std::nullopt;
  if (beside) walls = read_file_plan(*beside);
  if (!walls) return walls.error();
  if (options.up == TrackUp::y) {
    for (RowBlock& block : raw.blocks) std::ranges::for_each(block.rows, swap_up);
    raw.facts.has_z = true;
  }
  if (beside) raw.facts.remarks.push_back("The place is that of " + *beside + ".");
  auto tracks = tracks_of_rows(raw, file, options);
  if (!tracks) return tracks;
  tracks->reading = options;
  const bool has_walls = !walls->is_empty() || walls->unknown_shapes > 0;
  if (has_walls) tracks->plan = placed_plan(*walls, unit_of_walls(*walls, *tracks), tracks->origin);
  add_doubts(raw.facts, *tracks);
  if (progress) progress(1.0);
  return tracks;
}

bool looks_like_trajectories(const std::string& file) {
  const auto head = read_head(file);
  if (!head) return false;
  if (is_sqlite(*head) || is_xml(*head)) return true;
  if (is_json_document(*head)) {  // as models, presets and crowds are
    RawTracks tracks;
    return head->starts_with('[') || read_json_records(file, {}, tracks).has_value();
  }
  if (text_format_of(*head)) return true;
  // A table that is refused is still no model.
  std::filesystem::path name = file;
  if (name.extension() == ".gz") name.replace_extension();
  static constexpr std::array extensions{".csv",   ".tsv", ".txt",    ".traj", ".ndjson",
                                         ".jsonl", ".dat", ".sqlite", ".fzp",  ".pp"};
  return std::ranges::count(extensions, name.extension().string()) > 0;
}

}  // namespace throng
