#include "app/commands/inspect/tracks_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "app/commands/inspect/command.h"
#include "app/files/exit_status.h"
#include "app/people/measure/line_counts.h"
#include "app/people/measure/measure_table.h"
#include "engine/base/files/output_file.h"
#include "engine/base/json/json.h"
#include "engine/base/text/joined.h"
#include "engine/tracks/read.h"

namespace throng::app {
namespace {

/// The least and the most of a value.
struct Extent {
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  bool is_empty() const { return most < least; }
};

/// Sums up all rows.
struct TrackSums {
  Extent x, y;  ///< of the file, in metres
  Extent stature, stay;
  bool has_headings = false;
};

TrackSums sums_of(const Trajectories& tracks) {
  TrackSums sums;
  for (const PersonTrack& person : tracks.persons) {
    for (const TrackRow& row : person.rows) {
      sums.x.add(tracks.origin.x + static_cast<double>(row.x));
      sums.y.add(tracks.origin.y - static_cast<double>(row.z));
      sums.has_headings = sums.has_headings || !std::isnan(row.heading);
    }
    if (person.stature > 0.0F) sums.stature.add(static_cast<double>(person.stature));
    sums.stay.add(person.rows.back().seconds - person.rows.front().seconds);
  }
  return sums;
}

/// A kind of oddity in JSON, and for people, one and many.
struct OddityWords {
  const char* key;
  const char* one;
  const char* many;
};

/// The words for each kind, in the order of the kinds.
constexpr std::array<OddityWords, 5> oddity_words{
    {{"bad_row", "bad row, skipped", "bad rows, skipped"},
     {"duplicate", "row at a time that has one", "rows at times that have one"},
     {"gap", "gap", "gaps"},
     {"teleport", "jump, faster than 12 m/s", "jumps, faster than 12 m/s"},
     {"overlap", "pair that stands on each other", "pairs that stand on each other"}}};

const OddityWords& words_of(TrackOddity oddity) { return oddity_words.at(static_cast<std::size_t>(oddity)); }

std::string range_text(const Extent& extent, int decimals) {
  return fixed(extent.least, decimals) + " to " + fixed(extent.most, decimals);
}

double flow_of(std::size_t people, const LineCounts& passed) { return static_cast<double>(people) / passed.seconds; }

std::string plan_text(const GroundPlan& plan) {
  if (plan.is_empty()) return "none in or beside the file";
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* thing) {
    if (count > 0) parts.push_back(counted(count, thing));
  };
  add(plan.floors.size(), "floor");
  add(plan.obstacles.size(), "obstacle");
  add(plan.walls.size(), "wall");
  add(plan.exits.size(), "exit");
  add(plan.measurement_lines.size(), "measurement line");
  return joined(parts, ", ", " and ");
}

std::string passages_text(const LineCounts& passed) {
  std::string text = counted_people(passed.to_left) + " to the left and " + with_thousands(passed.to_right) +
                     " to the right in " + fixed(passed.seconds, 2) + " s";
  if (passed.seconds <= 0.0) return text;
  return text + ", " + fixed(flow_of(passed.to_left, passed), 3) + " and " +
         fixed(flow_of(passed.to_right, passed), 3) + " people a second";
}

Json passages_json(const LineCounts& passed) {
  const auto flow = [&](std::size_t people) { return passed.seconds > 0.0 ? Json(flow_of(people, passed)) : Json(); };
  return {{"seconds", passed.seconds},
          {"to_left", passed.to_left},
          {"to_left_a_second", flow(passed.to_left)},
          {"to_right", passed.to_right},
          {"to_right_a_second", flow(passed.to_right)}};
}

Json pair_json(double first, double second) { return Json::array({first, second}); }

/// Returns the first and the last second that are measured. Errors: the file has no row between them.
Result<std::pair<double, double>> measured_part(const Trajectories& tracks, const InspectOptions& options) {
  const auto [one_end, other_end] = options.tracks.part.value_or(std::pair(tracks.first_seconds, tracks.last_seconds));
  const std::pair part(std::min(one_end, other_end), std::max(one_end, other_end));
  if (part.second >= tracks.first_seconds && part.first <= tracks.last_seconds) return part;
  return Error{"--track-part: " + tracks.file + " has rows from " + fixed(tracks.first_seconds, 2) + " to " +
               fixed(tracks.last_seconds, 2) + " s of its clock"};
}

Status write_measures(const Trajectories& tracks, const InspectOptions& options, double first, double last) {
  const float cut_off = options.cut_off.value_or(Tuning().density_cut_off);
  Status written = write_whole_file(options.measures, measure_table(tracks, first, last, cut_off));
  if (written) end_with(exit_done, "wrote " + options.measures);
  return written;
}

}  // namespace

std::string tracks_text(const Trajectories& tracks, const LineCounts* passed) {
  const TrackSums sums = sums_of(tracks);
  std::string text = tracks.file + ": " + tracks.format + ", " + counted_people(tracks.persons.size()) + ", " +
                     counted(tracks.row_count, "row") + "\n";
  text += "  time    " + fixed(tracks.first_seconds, 2) + " to " + fixed(tracks.last_seconds, 2) + " s, " +
          fixed(tracks.rows_a_second, 2) + " rows a second of most people, who stay " + range_text(sums.stay, 1) +
          " s\n";
  text += "  place   " + fixed(sums.x.most - sums.x.least, 1) + " by " + fixed(sums.y.most - sums.y.least, 1) +
          " m: x " + range_text(sums.x, 2) + ", y " + range_text(sums.y, 2) + "\n";
  if (!sums.stature.is_empty()) text += "  people  " + range_text(sums.stature, 2) + " m tall\n";
  text +=
      std::string("  angles  ") + (sums.has_headings ? "the file says where people look" : "none in the file") + "\n";
  text += "  plan    " + plan_text(tracks.plan) + "\n";
  if (passed != nullptr) text += "  line    " + passages_text(*passed) + "\n";
  if (!tracks.remarks.empty() || !tracks.report.found.empty()) text += "\n";
  for (const std::string& remark : tracks.remarks) text += "noted: " + remark + "\n";
  for (const OddityCount& found : tracks.report.found) {
    const OddityWords& words = words_of(found.oddity);
    text += "odd: " + std::to_string(found.count) + " " + (found.count == 1 ? words.one : words.many) + "; first " +
            found.first + "\n";
  }
  return text;
}

std::string tracks_json(const Trajectories& tracks, const LineCounts* passed) {
  const TrackSums sums = sums_of(tracks);
  Json report = Json::array();
  for (const OddityCount& found : tracks.report.found) {
    report.push_back({{"count", found.count}, {"first", found.first}, {"kind", words_of(found.oddity).key}});
  }
  const GroundPlan& plan = tracks.plan;
  Json json = {{"extent_m", {{"x", pair_json(sums.x.least, sums.x.most)}, {"y", pair_json(sums.y.least, sums.y.most)}}},
               {"file", tracks.file},
               {"first_s", tracks.first_seconds},
               {"format", tracks.format},
               {"has_headings", sums.has_headings},
               {"last_s", tracks.last_seconds},
               {"origin_m", pair_json(tracks.origin.x, tracks.origin.y)},
               {"people", tracks.persons.size()},
               {"plan",
                {{"exits", plan.exits.size()},
                 {"floors", plan.floors.size()},
                 {"measurement_lines", plan.measurement_lines.size()},
                 {"obstacles", plan.obstacles.size()},
                 {"walls", plan.walls.size()}}},
               {"report", std::move(report)},
               {"rows", tracks.row_count},
               {"rows_a_second", tracks.rows_a_second},
               {"said", tracks.remarks}};
  json["stature_m"] = sums.stature.is_empty() ? Json() : pair_json(sums.stature.least, sums.stature.most);
  if (passed != nullptr) json["count_line"] = passages_json(*passed);
  return json.dump(2) + "\n";
}

Status inspect_tracks(const InspectOptions& options) {
  const auto tracks = read_trajectories(options.model, options.tracks.reading);
  if (!tracks) return tracks.error();
  const auto part = measured_part(*tracks, options);
  if (!part) return part.error();
  const auto [first, last] = *part;
  if (!options.measures.empty()) {
    if (Status written = write_measures(*tracks, options, first, last); !written) return written;
  }
  std::optional<LineCounts> passed;
  if (options.count_line) {
    passed = count_passages(*tracks, options.count_line->first, options.count_line->second, first, last);
  }
  const LineCounts* const counts = passed ? &*passed : nullptr;
  return print(options.json ? tracks_json(*tracks, counts) : tracks_text(*tracks, counts));
}

}  // namespace throng::app
