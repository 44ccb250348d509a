#include "engine/tracks/oddities.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/anim/bake/parallel.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"
#include "engine/tracks/reading_threads.h"

namespace throng {
namespace {

constexpr double longest_gap = 3.5;     // rows: three, and half of one for clocks that tremble
constexpr double least_jump = 0.1;      // metres: less is noise of a short step
constexpr float nearest_people = 0.1F;  // metres
constexpr std::size_t most_rows_looked_at = 150'000;
constexpr std::size_t most_pairs_looked_at = 5'000'000;

/// A person's place in a frame, with the cell of a grid that it lies in.
struct StandingRow {
  std::uint64_t key;  ///< frame, cell along z, cell along x
  std::uint32_t person, row;
};

/// Bits of a key for the cells along an axis: 13 km of them, more than a crowd may be wide.
constexpr unsigned cell_bits = 17;
constexpr std::uint64_t next_line = std::uint64_t{1} << cell_bits;

std::uint64_t cell_of(float place) {
  constexpr float half = 65536.0F;
  return static_cast<std::uint64_t>(std::clamp(std::floor(place / nearest_people) + half, 1.0F, 2.0F * half - 2.0F));
}

std::string person_at(const PersonTrack& person, double seconds) {
  return "person " + plain_text(person.id) + " at " + fixed(seconds, 2) + " s: ";
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
    constexpr auto fastest = static_cast<double>(fastest_person);
    if (squared > fastest * fastest * time * time && squared > least_jump * least_jump) {
      tally.teleports.add(row.seconds, [&] {
        return person_at(person, row.seconds) + fixed(std::sqrt(squared), 1) + " m in " + fixed(time, 2) + " s";
      });
    }
  }
}

/// Takes the rows of all frames, or of every nth where the work would be large.
std::vector<StandingRow> standers_of(const std::vector<PersonTrack>& persons, double rows_a_second, std::size_t rows) {
  const auto every = static_cast<std::int64_t>(rows / most_rows_looked_at + 1);
  const double rate = rows_a_second > 0.0 ? rows_a_second : 1.0;
  std::vector<StandingRow> standers;
  standers.reserve(std::min(rows, 2 * most_rows_looked_at));
  for (std::uint32_t person = 0; person < persons.size(); ++person) {
    const std::vector<TrackRow>& track = persons[person].rows;
    for (std::uint32_t row = 0; row < track.size(); ++row) {
      const auto frame =
          static_cast<std::int64_t>(std::clamp(std::floor(track[row].seconds * rate + 0.5), -1e15, 1e15));
      if (frame % every != 0) continue;
      const std::uint64_t line = static_cast<std::uint64_t>(frame / every) << cell_bits | cell_of(track[row].z);
      standers.push_back({line << cell_bits | cell_of(track[row].x), person, row});
    }
  }
  std::ranges::sort(standers, {}, &StandingRow::key);
  return standers;
}

bool overlap(const TrackRow& one, const TrackRow& other) {
  const float x = one.x - other.x, z = one.z - other.z, y = one.y - other.y;
  return std::abs(one.seconds - other.seconds) < 1e-3 && x * x + z * z < nearest_people * nearest_people &&
         std::abs(y) < 1.0F;
}

/// Finds pairs of people in cells that touch. Counts each pair once, however long they overlap.
class OverlapSearch {
 public:
  OverlapSearch(const std::vector<PersonTrack>& persons, std::vector<StandingRow> standers)
      : persons_(persons), standers_(std::move(standers)) {}

  OddityTally find() {
    std::size_t below = 0;  // the first stander of the next line of cells that may touch
    for (std::size_t i = 0; i < standers_.size() && looked_at_ < most_pairs_looked_at; ++i) {
      const std::uint64_t key = standers_[i].key;
      look_at(i, i + 1, key + 1);
      while (below < standers_.size() && standers_[below].key < key + next_line - 1) ++below;
      look_at(i, below, key + next_line + 1);
    }
    std::ranges::sort(pairs_);
    tally_.count = static_cast<std::size_t>(std::unique(pairs_.begin(), pairs_.end()) - pairs_.begin());
    return tally_;
  }

 private:
  const TrackRow& row_of(const StandingRow& stander) const { return persons_[stander.person].rows[stander.row]; }

  /// Compares one row with the rows from `first` on whose keys are not above `last_key`.
  void look_at(std::size_t one, std::size_t first, std::uint64_t last_key) {
    const StandingRow& stander = standers_[one];
    for (std::size_t i = first; i < standers_.size() && standers_[i].key <= last_key; ++i) {
      if (++looked_at_ > most_pairs_looked_at) return;
      const StandingRow& other = standers_[i];
      if (stander.person == other.person || !overlap(row_of(stander), row_of(other))) continue;
      const std::uint32_t earlier = std::min(stander.person, other.person);
      const std::uint32_t later = std::max(stander.person, other.person);
      pairs_.emplace_back(earlier, later);
      const double seconds = row_of(stander).seconds;
      tally_.add(seconds, [&] {
        return "persons " + plain_text(persons_[earlier].id) + " and " + plain_text(persons_[later].id) + " at " +
               fixed(seconds, 2) + " s";
      });
    }
  }

  const std::vector<PersonTrack>& persons_;
  std::vector<StandingRow> standers_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  std::size_t looked_at_ = 0;
  OddityTally tally_;
};

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
  std::size_t rows = 0;
  for (const PersonTrack& person : persons) rows += person.rows.size();
  MoveTally moves;
  OddityTally overlaps;
  const auto look = [&](std::size_t part) {
    if (part == 1) {
      overlaps = OverlapSearch(persons, standers_of(persons, rows_a_second, rows)).find();
    } else {
      for (const PersonTrack& person : persons) look_at_moves(person, rows_a_second, moves);
    }
  };
  if (rows < rows_worth_a_thread) {
    look(0);
    look(1);
  } else {
    anim::in_parallel(2, look);
  }
  report_oddity(TrackOddity::gap, moves.gaps, report);
  report_oddity(TrackOddity::teleport, moves.teleports, report);
  report_oddity(TrackOddity::overlap, overlaps, report);
}

}  // namespace throng
