#include "engine/tracks/text/clock_text.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cstddef>

#include "engine/tracks/text/number_text.h"

namespace throng {
namespace {

/// Takes whole numbers with a mark between them off the front of a text.
template <std::size_t count>
bool take_numbers(std::string_view& text, char mark, std::array<int, count>& numbers) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (text.empty() || text.front() != mark)) return false;
    if (i > 0) text.remove_prefix(1);
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), numbers.at(i));
    if (error != std::errc() || numbers.at(i) < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  }
  return true;
}

/// Takes the date and the letter or blank behind it off the front of a text.
bool take_date(std::string_view& text, double& seconds) {
  std::array<int, 3> date{};
  if (!take_numbers(text, '-', date) || text.empty() || (text.front() != 'T' && text.front() != ' ')) return false;
  text.remove_prefix(1);
  const std::chrono::year_month_day day{std::chrono::year(date[0]), std::chrono::month(static_cast<unsigned>(date[1])),
                                        std::chrono::day(static_cast<unsigned>(date[2]))};
  if (!day.ok()) return false;
  seconds = std::chrono::duration<double>(std::chrono::sys_days(day).time_since_epoch()).count();
  return true;
}

}  // namespace

bool is_clock_text(std::string_view text, double& value) {
  value = 0.0;
  if (text.find(':') > 2 && !take_date(text, value)) return false;
  if (const std::size_t zone = text.find_first_of("Z+-"); zone != std::string_view::npos) text = text.substr(0, zone);
  std::array<int, 2> hours_and_minutes{};
  double seconds = 0.0;
  if (!take_numbers(text, ':', hours_and_minutes) || !text.starts_with(':')) return false;
  const bool has_seconds = is_number_text(text.substr(1), seconds) || is_decimal_comma_text(text.substr(1), seconds);
  if (!has_seconds || seconds >= 61.0 || hours_and_minutes[1] > 59) return false;
  value += 3600.0 * hours_and_minutes[0] + 60.0 * hours_and_minutes[1] + seconds;
  return true;
}

}  // namespace throng
