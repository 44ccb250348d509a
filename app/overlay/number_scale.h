#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace throng::app {

/// Which numbers a row accepts and how it writes them.
struct NumberScale {
  double lowest = 0, highest = 1;
  int decimals = 0;
  bool logarithmic = false;
  const char* zero_word = nullptr;  ///< written instead of 0, and may be typed
  const char* suffix = "";          ///< the unit after the number; may be left out when typing
  std::span<const int> stops = {};  ///< when not empty, the only numbers accepted
};

/// The scale of the tuning's value with that key.
NumberScale scale_of(std::string_view key, std::span<const int> stops = {});

/// The nearest number that the scale accepts.
double accepted(const NumberScale& scale, double value);
/// Where a number lies along its track, 0 to 1, and back.
double place_of(const NumberScale& scale, double value);
double value_at(const NumberScale& scale, double place);
/// How a number is written, and what a text means: nothing if it is no number.
std::string written(const NumberScale& scale, double value);
std::optional<double> meant(const NumberScale& scale, const std::string& text);

}  // namespace throng::app
