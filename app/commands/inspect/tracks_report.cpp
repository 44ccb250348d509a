// The answer about a file of trajectories.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "app/commands/inspect/report.h"
#include "engine/base/json/json.h"
#include "engine/base/text/joined.h"

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

Json pair_json(double first, double second) { return Json::array({first, second}); }

}  // namespace

std::string tracks_text(const Trajectories& tracks) {
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
  if (!tracks.remarks.empty() || !tracks.report.found.empty()) text += "\n";
  for (const std::string& remark : tracks.remarks) text += "noted: " + remark + "\n";
  for (const OddityCount& found : tracks.report.found) {
    const OddityWords& words = words_of(found.oddity);
    text += "odd: " + std::to_string(found.count) + " " + (found.count == 1 ? words.one : words.many) + "; first " +
            found.first + "\n";
  }
  return text;
}

std::string tracks_json(const Trajectories& tracks) {
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
  return json.dump(2) + "\n";
}

}  // namespace throng::app
