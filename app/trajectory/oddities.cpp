#include "app/trajectory/oddities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "app/files/joined.h"
#include "app/trajectory/both_cores.h"

namespace throng::app {
namespace {

constexpr double fastest = 12.0;        // metres a second
constexpr double longest_gap = 3.5;     // rows: three, and half of one for clocks that tremble
constexpr double least_jump = 0.1;      // metres: less is noise of a short step
constexpr float nearest_people = 0.1F;  // metres
constexpr std::size_t most_rows_looked_at = 300'000;
constexpr std::size_t most_pairs_looked_at = 5'000'000;

/// A place of somebody in a frame, with the cell of a grid that it lies in.
struct Stander {
  std::int64_t frame;
  std::int64_t cell_z;
  std::int64_t cell_x;
  const TrackRow* row;
  std::uint32_t person;

  auto key() const { return std::array{frame, cell_z, cell_x}; }
};

std::string person_at(const PersonTrack& person, double seconds) {
  return "person " + person.id + " at " + fixed(seconds, 2) + " s: ";
}

struct MoveTally {
  OddityTally gaps, teleports;
};

void look_at_moves(const PersonTrack& person, double rows_a_second, MoveTally& tally) {
  const double gap = rows_a_second > 0.0 ? longest_gap / rows_a_second : 0.0;
  for (std::size_t i = 1; i < person.rows.size(); ++i) {
    const TrackRow &before = person.rows[i - 1], &row = person.rows[i];
    const double time = row.seconds - before.seconds;
    const float x = row.x - before.x, z = row.z - before.z;
    const double squared = static_cast<double>(x * x + z * z);
    if (gap > 0.0 && time > gap) {
      tally.gaps.add(before.seconds,
                     [&] { return person_at(person, before.seconds) + "no row for " + fixed(time, 2) + " s"; });
    }
    if (squared > fastest * fastest * time * time && squared > least_jump * least_jump) {
      tally.teleports.add(row.seconds, [&] {
        return person_at(person, row.seconds) + fixed(std::sqrt(squared), 1) + " m in " + fixed(time, 2) + " s";
      });
    }
  }
}

/// Takes the rows of some frames: of all, or of every so many that the work stays small.
std::vector<Stander> standers_of(const std::vector<PersonTrack>& persons, double rows_a_second) {
  std::size_t rows = 0;
  for (const PersonTrack& person : persons) rows += person.rows.size();
  const auto every = static_cast<std::int64_t>(rows / most_rows_looked_at + 1);
  const double rate = rows_a_second > 0.0 ? rows_a_second : 1.0;
  std::vector<Stander> standers;
  for (std::uint32_t number = 0; number < persons.size(); ++number) {
    for (const TrackRow& row : persons[number].rows) {
      const auto frame = static_cast<std::int64_t>(std::floor(row.seconds * rate + 0.5));
      if (frame % every != 0) continue;
      standers.push_back({frame, static_cast<std::int64_t>(std::floor(row.z / nearest_people)),
                          static_cast<std::int64_t>(std::floor(row.x / nearest_people)), &row, number});
    }
  }
  std::ranges::sort(standers, {}, &Stander::key);
  return standers;
}

bool overlap(const Stander& one, const Stander& other) {
  const float x = one.row->x - other.row->x, z = one.row->z - other.row->z, y = one.row->y - other.row->y;
  return one.person != other.person && std::abs(one.row->seconds - other.row->seconds) < 1e-3 &&
         x * x + z * z < nearest_people * nearest_people && std::abs(y) < 1.0F;
}

/// Finds pairs of people in cells that touch. Counts each pair once, however long they stand so.
OddityTally find_overlaps(const std::vector<PersonTrack>& persons, double rows_a_second) {
  const std::vector<Stander> standers = standers_of(persons, rows_a_second);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  OddityTally tally;
  std::size_t below = 0, looked_at = 0;  // `below`: the first stander of the next row of cells that may touch
  for (std::size_t i = 0; i < standers.size() && looked_at < most_pairs_looked_at; ++i) {
    const Stander& one = standers[i];
    const auto look_at = [&](const Stander& other) {
      ++looked_at;
      if (!overlap(one, other)) return;
      pairs.emplace_back(std::minmax(one.person, other.person));
      tally.add(one.row->seconds, [&] {
        return "persons " + persons[one.person].id + " and " + persons[other.person].id + " at " +
               fixed(one.row->seconds, 2) + " s";
      });
    };
    for (std::size_t j = i + 1; j < standers.size() && looked_at < most_pairs_looked_at; ++j) {
      if (standers[j].key() > std::array{one.frame, one.cell_z, one.cell_x + 1}) break;
      look_at(standers[j]);
    }
    while (below < standers.size() && standers[below].key() < std::array{one.frame, one.cell_z + 1, one.cell_x - 1}) {
      ++below;
    }
    for (std::size_t j = below; j < standers.size() && looked_at < most_pairs_looked_at; ++j) {
      if (standers[j].key() > std::array{one.frame, one.cell_z + 1, one.cell_x + 1}) break;
      look_at(standers[j]);
    }
  }
  std::ranges::sort(pairs);
  tally.count = static_cast<std::size_t>(std::ranges::unique(pairs).begin() - pairs.begin());
  return tally;
}

}  // namespace

void OddityTally::add(const OddityTally& other) {
  if (other.count == 0) return;
  if (count == 0 || other.first_seconds < first_seconds) {
    first_seconds = other.first_seconds;
    first = other.first;
  }
  count += other.count;
}

void report_oddity(TrackOddity oddity, const OddityTally& tally, TrackReport& report) {
  if (tally.count > 0) report.found.push_back({oddity, tally.count, tally.first});
}

void find_oddities(const std::vector<PersonTrack>& persons, double rows_a_second, TrackReport& report) {
  MoveTally moves;
  OddityTally overlaps;
  run_side_by_side(2, [&](std::size_t part) {
    if (part == 1) {
      overlaps = find_overlaps(persons, rows_a_second);
      return;
    }
    for (const PersonTrack& person : persons) look_at_moves(person, rows_a_second, moves);
  });
  report_oddity(TrackOddity::gap, moves.gaps, report);
  report_oddity(TrackOddity::teleport, moves.teleports, report);
  report_oddity(TrackOddity::overlap, overlaps, report);
}

}  // namespace throng::app
