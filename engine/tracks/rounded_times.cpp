#include "engine/tracks/rounded_times.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

constexpr std::size_t most_first_rows = 4000;

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
  for (std::size_t count = 0; !rows.empty() && count < most_first_rows; ++count) {
    const std::size_t end = rows.find('\n');
    const std::vector<std::string> fields = fields_of(rows.substr(0, end), layout.separator);
    Moment moment;
    const bool is_row = fields.size() > std::max({id, frame, time}) && is_number_text(fields[frame], moment.frame) &&
                        is_number_text(fields[time], moment.time);
    if (is_row) people[fields[id]].push_back(moment);
    rows.remove_prefix(end == std::string_view::npos ? rows.size() : end + 1);
  }
  return people;
}

}  // namespace

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
