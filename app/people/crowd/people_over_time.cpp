#include "app/people/crowd/people_over_time.h"

#include <algorithm>

namespace throng::app {
namespace {

std::size_t count_until(const std::vector<double>::const_iterator& end, const std::vector<double>& times) {
  return static_cast<std::size_t>(end - times.begin());
}

}  // namespace

PeopleOverTime::PeopleOverTime(const Trajectories& all)
    : most_by_column_(columns), first_(all.first_seconds), last_(all.last_seconds), row_(row_seconds(all)) {
  for (const PersonTrack& person : all.persons) {
    const Presence presence = presence_of(person, row_);
    firsts_.push_back(presence.first);
    lasts_.push_back(presence.last);
  }
  std::ranges::sort(firsts_);
  std::ranges::sort(lasts_);
  // The number of people grows only where a person comes.
  auto next = firsts_.begin();
  for (std::size_t column = 0; column < columns; ++column) {
    const auto time_at = [&](std::size_t begin) {
      return first_ + (last_ - first_) * static_cast<double>(begin) / static_cast<double>(columns);
    };
    std::size_t most = at(time_at(column));
    for (const bool is_last = column + 1 == columns; next != firsts_.end() && (is_last || *next < time_at(column + 1));
         ++next) {
      most = std::max(most, at(*next));
    }
    most_by_column_[column] = static_cast<std::uint32_t>(most);
    most_ = std::max(most_, most);
  }
}

std::size_t PeopleOverTime::at(double seconds) const {
  return count_until(std::ranges::upper_bound(firsts_, seconds), firsts_) -
         count_until(std::ranges::lower_bound(lasts_, seconds), lasts_);
}

}  // namespace throng::app
