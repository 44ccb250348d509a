#include "engine/tracks/tracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/anim/bake/parallel.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/tracks/oddities.h"
#include "engine/tracks/reading_threads.h"
#include "engine/tracks/text_rows.h"

namespace throng {
namespace {

constexpr double widest_crowd = 10'000.0;  // metres: floats are exact to 0.5 mm there, to 0.1 mm in two kilometres
constexpr double stature_share = 0.95;     // of a person's heights of the head, which go up and down with each step

/// The smallest and the largest place of a file.
struct RowBounds {
  double least_x = std::numeric_limits<double>::infinity(), most_x = -least_x;
  double least_y = least_x, most_y = -least_x;
  std::size_t count = 0;

  void add(const RawRow& row) {
    least_x = std::min(least_x, row.x);
    most_x = std::max(most_x, row.x);
    least_y = std::min(least_y, row.y);
    most_y = std::max(most_y, row.y);
  }
  double width() const { return std::max(most_x - least_x, most_y - least_y); }
  glm::dvec2 middle() const { return {(least_x + most_x) / 2.0, (least_y + most_y) / 2.0}; }
};

/// Gives the rows of all threads the numbers of one table, in the order of the file, and counts them.
RowBounds number_people(RawTracks& tracks, std::vector<std::uint32_t>& counts) {
  constexpr std::uint32_t unseen = 0xFFFFFFFF;
  std::vector<std::vector<std::uint32_t>> numbers;
  for (const IdTable& table : tracks.tables) numbers.emplace_back(table.size(), unseen);
  IdTable people;
  RowBounds bounds;
  for (RowBlock& block : tracks.blocks) {
    const IdTable& table = tracks.tables[block.table];
    std::vector<std::uint32_t>& known = numbers[block.table];
    for (RawRow& row : block.rows) {
      std::uint32_t& number = known[row.person];
      if (number == unseen) {
        number = people.number_of(table.id(row.person));
        counts.resize(people.size(), 0);
      }
      row.person = number;
      ++counts[number];
      bounds.add(row);
    }
    bounds.count += block.rows.size();
    block.table = 0;
  }
  tracks.tables.clear();
  tracks.tables.push_back(std::move(people));
  return bounds;
}

/// Moves rows to their people, and frees the blocks after that.
std::vector<PersonTrack> take_rows(RawTracks& tracks, const std::vector<std::uint32_t>& counts, const RowScale& scale,
                                   const glm::dvec2& origin, std::size_t parts) {
  std::vector<PersonTrack> persons(counts.size());
  for (std::size_t i = 0; i < persons.size(); ++i) {
    persons[i].id = tracks.tables.front().id(static_cast<std::uint32_t>(i));
    persons[i].rows.reserve(counts[i]);
  }
  anim::in_parallel(parts, [&](std::size_t part) {
    const auto first = static_cast<std::uint32_t>(persons.size() * part / parts);
    const auto count = static_cast<std::uint32_t>(persons.size() * (part + 1) / parts) - first;
    for (const RowBlock& block : tracks.blocks) {
      for (const RawRow& raw : block.rows) {
        if (raw.person - first < count) persons[raw.person].rows.push_back(track_row(raw, scale, origin));
      }
    }
  });
  tracks.blocks.clear();
  return persons;
}

/// Takes the stature of a person from the heights of the head, which stand where the ground's will.
void take_stature(PersonTrack& person, std::vector<float>& heights) {
  heights.clear();
  for (TrackRow& row : person.rows) heights.push_back(std::exchange(row.y, 0.0F));
  const auto at =
      heights.begin() + static_cast<std::ptrdiff_t>(stature_share * static_cast<double>(heights.size() - 1));
  std::ranges::nth_element(heights, at);
  if (*at > 0.3F && *at < 2.6F) person.stature = *at;
}

/// Leaves the last of rows at one time. Rows that only repeat another are not counted where `repeats` is true.
void drop_duplicates(PersonTrack& person, bool repeats, OddityTally& tally) {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < person.rows.size(); ++i) {
    TrackRow &last = person.rows[kept], &row = person.rows[i];
    if (row.seconds > last.seconds) {
      person.rows[++kept] = row;
      continue;
    }
    const bool is_same = std::hypot(row.x - last.x, row.z - last.z) < 1e-3F;
    if (!repeats || !is_same) {
      tally.add(row.seconds, [&] { return "person " + plain_text(person.id) + " at " + fixed(row.seconds, 2) + " s"; });
    }
    last = row;
  }
  person.rows.resize(std::min(kept + 1, person.rows.size()));
}

void sort_rows(PersonTrack& person) {
  const auto earlier = [](const TrackRow& one, const TrackRow& other) { return one.seconds < other.seconds; };
  if (!std::ranges::is_sorted(person.rows, earlier)) std::ranges::stable_sort(person.rows, earlier);
}

/// Does all work that belongs to each person alone, on both cores.
OddityTally finish_people(std::vector<PersonTrack>& persons, const RowScale& scale, const RowFacts& facts,
                          std::size_t parts) {
  std::vector<OddityTally> tallies(parts);
  anim::in_parallel(parts, [&](std::size_t part) {
    std::vector<float> heights;
    const std::size_t end = persons.size() * (part + 1) / parts;
    for (std::size_t i = persons.size() * part / parts; i < end; ++i) {
      if (scale.angle != AngleMeaning::heading && facts.angle != AngleMeaning::none) {
        for (TrackRow& row : persons[i].rows) row.heading = heading_of_angle(row.heading, scale.angle);
      }
      sort_rows(persons[i]);
      drop_duplicates(persons[i], facts.repeats_ends, tallies[part]);
      if (scale.z_is_head) take_stature(persons[i], heights);
    }
  });
  OddityTally all;
  for (const OddityTally& tally : tallies) all.add(tally);
  return all;
}

/// The rate of most people, over some of their steps.
double common_rate(const std::vector<PersonTrack>& persons) {
  constexpr std::size_t most_steps = 100'000;
  std::vector<double> steps;
  for (const PersonTrack& person : persons) {
    for (std::size_t i = 1; i < person.rows.size() && steps.size() < most_steps; ++i) {
      steps.push_back(person.rows[i].seconds - person.rows[i - 1].seconds);
    }
  }
  if (steps.empty()) return 0.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return std::round(1e6 / std::max(*middle, 1e-6)) / 1e6;  // 25, and not nearly 25
}

void sum_up(Trajectories& trajectories) {
  std::ranges::stable_sort(trajectories.persons, {}, [](const PersonTrack& person) { return person.rows[0].seconds; });
  trajectories.first_seconds = trajectories.persons.front().rows.front().seconds;
  trajectories.last_seconds = trajectories.first_seconds;
  for (const PersonTrack& person : trajectories.persons) {
    trajectories.row_count += person.rows.size();
    trajectories.last_seconds = std::max(trajectories.last_seconds, person.rows.back().seconds);
  }
  trajectories.rows_a_second = common_rate(trajectories.persons);
}

}  // namespace

TrackRow track_row(const RawRow& raw, const RowScale& scale, const glm::dvec2& origin) {
  TrackRow row;
  row.seconds = raw.time / scale.times_a_second;
  row.x = static_cast<float>(raw.x * scale.metres_a_unit - origin.x);
  row.z = static_cast<float>(origin.y - raw.y * scale.metres_a_unit);
  if (scale.has_heights) row.y = static_cast<float>(static_cast<double>(raw.z) * scale.metres_a_unit);
  row.heading = raw.angle;
  return row;
}

void swap_up(RawRow& row) {
  const double height = row.y;
  row.y = -static_cast<double>(row.z);
  row.z = static_cast<float>(height);
}

float heading_of_angle(float angle, AngleMeaning meaning) {
  constexpr float pi = std::numbers::pi_v<float>;
  switch (meaning) {
    case AngleMeaning::degrees:
      return std::remainder(angle * (pi / 180.0F) + pi / 2.0F, 2.0F * pi);
    case AngleMeaning::radians:
      return std::remainder(angle + pi / 2.0F, 2.0F * pi);
    case AngleMeaning::compass:
      return std::remainder(pi - angle * (pi / 180.0F), 2.0F * pi);
    case AngleMeaning::heading:
      return angle;
    case AngleMeaning::none:
    case AngleMeaning::unknown:
      break;
  }
  return std::numeric_limits<float>::quiet_NaN();
}

Result<Trajectories> tracks_of_rows(RawTracks& tracks, const std::string& file, const TrackReading& options) {
  std::vector<std::uint32_t> counts;
  const RowBounds bounds = number_people(tracks, counts);
  if (counts.empty()) {
    const std::string skipped = tracks.bad_rows > 0 ? "every row is wrong, the first " + tracks.first_bad_row
                                                    : "it has no rows; name a file with some";
    return Error{file + ": " + skipped};
  }
  if (counts.size() > most_people) return too_many_people(file);
  const auto scale = tell_apart(tracks, options);
  if (!scale) return Error{file + ": " + scale.error().message};
  if (const double width = bounds.width() * scale->metres_a_unit; width > widest_crowd) {
    return Error{file + ": its people are up to " + fixed(width / 1000.0, 1) +
                 " km apart, and 10 km is the most; cut the file, or say with --unit how many metres a unit is"};
  }
  Trajectories result;
  const glm::dvec2 middle = bounds.middle() * scale->metres_a_unit;
  result.origin = {std::round(middle.x) + 0.0, std::round(middle.y) + 0.0};  // -0 becomes 0
  const std::size_t parts = bounds.count < rows_worth_a_thread ? 1 : reading_threads();
  result.persons = take_rows(tracks, counts, *scale, result.origin, parts);
  const OddityTally duplicates = finish_people(result.persons, *scale, tracks.facts, parts);
  sum_up(result);
  report_oddity(TrackOddity::bad_row, {.count = tracks.bad_rows, .first = tracks.first_bad_row}, result.report);
  report_oddity(TrackOddity::duplicate, duplicates, result.report);
  find_oddities(result.persons, result.rows_a_second, result.report);
  result.plan = placed_plan(tracks.plan, scale->metres_a_unit, result.origin);
  result.file = file;
  result.format = tracks.facts.format;
  result.remarks = tracks.facts.remarks;
  return result;
}

}  // namespace throng
