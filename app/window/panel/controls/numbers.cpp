#include "app/window/panel/controls/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "app/settings/tuning_values.h"

namespace throng::app {
namespace {

/// The axis along which the track is even.
double stretched(const NumberScale& scale, double value) {
  return scale.logarithmic ? std::log(std::max(value, 1e-6)) : value;
}

std::size_t nearest_stop(const NumberScale& scale, double value) {
  const auto nearest = std::ranges::min_element(scale.stops, {}, [value](int stop) { return std::abs(stop - value); });
  return static_cast<std::size_t>(std::distance(scale.stops.begin(), nearest));
}

std::string without_spaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

// "12,345" is written with thousands; in "3,5" the comma is the point of a person who writes it so.
bool has_thousands(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t first = text.find(',');
  if (first == 0 || first > 3) return false;
  for (std::size_t comma = first; comma < text.size() && text[comma] == ','; comma += 4) {
    const std::string_view digits = text.substr(comma + 1, 3);
    if (digits.size() < 3 || !std::ranges::all_of(digits, [](char letter) { return letter >= '0' && letter <= '9'; })) {
      return false;
    }
    const std::size_t next = comma + 4;
    if (next < text.size() && text[next] >= '0' && text[next] <= '9') return false;
  }
  return true;
}

std::string with_point(const std::string& text) {
  std::string digits = without_spaces(text);
  if (has_thousands(digits)) {
    std::erase(digits, ',');
  } else {
    std::ranges::replace(digits, ',', '.');
  }
  return digits;
}

}  // namespace

std::string as_percent(float share) { return fixed(100 * static_cast<double>(share), 0) + " %"; }

NumberScale scale_of(std::string_view key, std::span<const int> stops) {
  const TuningValue& value = tuning_value(key);
  const Track& track = value.track;
  const bool shows_part = track.most > track.least;
  return {.lowest = shows_part ? track.least : value.least,
          .highest = shows_part ? track.most : value.most,
          .decimals = track.decimals,
          .logarithmic = track.logarithmic,
          .zero_word = track.zero_word,
          .suffix = track.suffix,
          .stops = stops,
          .least_typed = value.least,
          .most_typed = value.most};
}

double accepted(const NumberScale& scale, double value) {
  if (!scale.stops.empty()) return scale.stops[nearest_stop(scale, value)];
  const double parts = std::pow(10.0, scale.decimals);
  return std::clamp(std::round(value * parts) / parts, scale.least_typed, scale.most_typed);
}

double place_of(const NumberScale& scale, double value) {
  if (!scale.stops.empty()) {
    return static_cast<double>(nearest_stop(scale, value)) / static_cast<double>(scale.stops.size() - 1);
  }
  const double low = stretched(scale, scale.lowest), high = stretched(scale, scale.highest);
  return std::clamp((stretched(scale, value) - low) / (high - low), 0.0, 1.0);
}

double value_at(const NumberScale& scale, double place) {
  place = std::clamp(place, 0.0, 1.0);
  if (!scale.stops.empty()) {
    return scale.stops[static_cast<std::size_t>(std::lround(place * static_cast<double>(scale.stops.size() - 1)))];
  }
  const double between = std::lerp(stretched(scale, scale.lowest), stretched(scale, scale.highest), place);
  return accepted(scale, scale.logarithmic ? std::exp(between) : between);
}

double stepped(const NumberScale& scale, double value, int steps) {
  if (!scale.stops.empty()) {
    const auto last = static_cast<int>(scale.stops.size()) - 1;
    const int place = static_cast<int>(nearest_stop(scale, value)) + steps;
    return scale.stops[static_cast<std::size_t>(std::clamp(place, 0, last))];
  }
  constexpr double share_of_track = 0.01;
  const double least = value + steps * std::pow(10.0, -scale.decimals);
  if (!scale.logarithmic || value < scale.lowest || value > scale.highest) return accepted(scale, least);
  const double further = value_at(scale, place_of(scale, value) + steps * share_of_track);
  return accepted(scale, steps > 0 ? std::max(further, least) : std::min(further, least));
}

std::string written(const NumberScale& scale, double value) {
  if (value == 0 && scale.zero_word != nullptr) return scale.zero_word;
  return with_thousands(fixed(value, scale.decimals)) + scale.suffix;
}

std::optional<double> meant(const NumberScale& scale, const std::string& text) {
  if (scale.zero_word != nullptr && text == scale.zero_word) return 0;
  const std::string digits = with_point(text);
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  const std::string rest = end;
  if (end == digits.c_str() || !std::isfinite(value)) return std::nullopt;
  if (!rest.empty() && rest != without_spaces(scale.suffix)) return std::nullopt;
  return accepted(scale, value);
}

}  // namespace throng::app
