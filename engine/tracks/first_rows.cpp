#include "engine/tracks/first_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

using FirstNumbers = std::array<double, 4>;

constexpr std::size_t most_rows = 4000;

/// Calls `visit` with the fields of one row after the other while it returns true.
template <class Visit>
void visit_rows(std::string_view rows, char separator, const Visit& visit) {
  while (!rows.empty()) {
    const std::size_t end = rows.find('\n');
    if (!visit(fields_of(rows.substr(0, end), separator))) return;
    rows.remove_prefix(end == std::string_view::npos ? rows.size() : end + 1);
  }
}

std::vector<FirstNumbers> numbers_of(std::string_view rows, char separator) {
  std::vector<FirstNumbers> result;
  visit_rows(rows, separator, [&](const std::vector<std::string>& fields) {
    FirstNumbers numbers{};
    bool is_row = fields.size() >= numbers.size();
    for (std::size_t i = 0; is_row && i < numbers.size(); ++i) is_row = is_number_text(fields[i], numbers[i]);
    if (is_row) result.push_back(numbers);
    return result.size() < most_rows;
  });
  return result;
}

/// Says how the rows of a person follow each other, in the median of all.
struct Succession {
  std::size_t count = 0;
  double metres = 0.0;  ///< from a row to the next, in the file's unit
  double usual = 0.0;   ///< the time from a row to the next that is most common
  double even = 0.0;    ///< the share of rows at the usual distance in time
};

Succession succession_of(std::vector<FirstNumbers> rows, std::size_t id, std::size_t frame) {
  std::ranges::stable_sort(rows, [&](const FirstNumbers& a, const FirstNumbers& b) {
    return a[id] != b[id] ? a[id] < b[id] : a[frame] < b[frame];
  });
  std::vector<double> distances;
  std::map<double, std::size_t> steps;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][id] != rows[i - 1][id]) continue;
    distances.push_back(std::hypot(rows[i][2] - rows[i - 1][2], rows[i][3] - rows[i - 1][3]));
    ++steps[std::round(1e4 * (rows[i][frame] - rows[i - 1][frame])) / 1e4];
  }
  Succession result{.count = distances.size()};
  if (distances.empty()) return result;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::ranges::nth_element(distances, middle);
  const auto common = std::ranges::max_element(steps, {}, [](const auto& step) { return step.second; });
  result.metres = *middle;
  result.usual = common->first;
  result.even = static_cast<double>(common->second) / static_cast<double>(distances.size());
  return result;
}

/// Returns whether rows follow each other better in `a` than in `b`.
bool follows_better(const Succession& a, const Succession& b) {
  constexpr double clearly = 0.05;
  if (a.count == 0 || b.count == 0) return b.count == 0 && a.count > 0;
  return std::abs(a.even - b.even) > clearly ? a.even > b.even : a.metres < b.metres;
}

struct Moment {
  double frame = 0.0, time = 0.0;
};

std::size_t place_of(const TableLayout& layout, TrackField field) {
  return static_cast<std::size_t>(layout.column_of(field) - layout.columns.data());
}

/// Returns the moments of each person, in the order of the file.
std::map<std::string, std::vector<Moment>> moments_of(std::string_view rows, const TableLayout& layout) {
  const std::size_t id = place_of(layout, TrackField::id), frame = place_of(layout, TrackField::frame),
                    time = place_of(layout, TrackField::time);
  std::map<std::string, std::vector<Moment>> people;
  std::size_t count = 0;
  visit_rows(rows, layout.separator, [&](const std::vector<std::string>& fields) {
    Moment moment;
    const bool is_row = fields.size() > std::max({id, frame, time}) && is_number_text(fields[frame], moment.frame) &&
                        is_number_text(fields[time], moment.time);
    if (is_row) people[fields[id]].push_back(moment);
    return ++count < most_rows;
  });
  return people;
}

}  // namespace

FirstColumns first_columns_of(std::string_view rows, char separator) {
  const std::vector<FirstNumbers> numbers = numbers_of(rows, separator);
  const Succession id_first = succession_of(numbers, 0, 1), frame_first = succession_of(numbers, 1, 0);
  FirstColumns result{.frame_is_first = follows_better(frame_first, id_first)};
  const std::size_t frame = result.frame_is_first ? 0 : 1;
  result.counts_frames =
      std::ranges::all_of(numbers, [&](const FirstNumbers& row) { return row.at(frame) == std::floor(row.at(frame)); });
  result.skips_frames = (result.frame_is_first ? frame_first : id_first).usual > 1.0;
  return result;
}

RoundedTimes rounded_times_of(std::string_view rows, const TableLayout& layout) {
  std::size_t steps = 0, at_one_time = 0;
  std::map<double, double> first_frames;  // of each time
  for (const auto& [id, moments] : moments_of(rows, layout)) {
    for (std::size_t i = 0; i < moments.size(); ++i) {
      const auto [found, is_new] = first_frames.try_emplace(moments[i].time, moments[i].frame);
      found->second = std::min(found->second, moments[i].frame);
      if (i == 0 || moments[i].frame <= moments[i - 1].frame) continue;
      ++steps;
      if (moments[i].time == moments[i - 1].time) ++at_one_time;
    }
  }
  RoundedTimes result{.are_rounded = steps >= 10 && at_one_time * 10 >= steps};
  if (!result.are_rounded || first_frames.size() < 3) return result;
  const auto begin = std::next(first_frames.begin()), end = std::prev(first_frames.end());  // the first time is cut off
  const double frames = end->second - begin->second;
  if (frames > 0.0) result.rate = frames / (end->first - begin->first);
  return result;
}

}  // namespace throng
