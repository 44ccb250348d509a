#include "engine/tracks/first_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text/table_layout.h"

namespace throng {
namespace {

using FirstNumbers = std::array<double, 4>;

constexpr std::size_t most_rows = 4000;

std::vector<FirstNumbers> numbers_of(std::string_view rows, char separator) {
  std::vector<FirstNumbers> result;
  while (!rows.empty() && result.size() < most_rows) {
    const std::size_t end = rows.find('\n');
    const std::vector<std::string> fields = fields_of(rows.substr(0, end), separator);
    FirstNumbers numbers{};
    bool is_row = fields.size() >= numbers.size();
    for (std::size_t i = 0; is_row && i < numbers.size(); ++i) is_row = is_number_text(fields[i], numbers[i]);
    if (is_row) result.push_back(numbers);
    rows.remove_prefix(end == std::string_view::npos ? rows.size() : end + 1);
  }
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

}  // namespace throng
