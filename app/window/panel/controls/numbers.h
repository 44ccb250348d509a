#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/text/joined.h"

namespace throng::app {

std::string as_percent(float share);  ///< "25 %", of a share of 0 to 1

/// The numbers that a row accepts, and how it writes them.
struct NumberScale {
  double lowest = 0, highest = 1;  ///< the ends of the track
  int decimals = 0;
  bool logarithmic = false;
  const char* zero_word = nullptr;  ///< written instead of 0, and may be typed
  const char* suffix = "";          ///< the unit after the number; may be left out when typing
  std::span<const int> stops = {};  ///< when not empty, the only numbers accepted
  double least_typed = lowest,
         most_typed = highest;  ///< the range of what is typed, where the track shows a part of it
};

/// Returns the scale of the tuning's value with that key.
NumberScale scale_of(std::string_view key, std::span<const int> stops = {});

/// Returns the nearest number that the scale accepts.
double accepted(const NumberScale& scale, double value);
/// Returns the place of a number along its track, 0 to 1.
double place_of(const NumberScale& scale, double value);
/// Returns the number at a place of the track.
double value_at(const NumberScale& scale, double place);
/// Returns the number so many steps further. A step is one of the last digit that is written, the next stop, or a
/// hundredth of a logarithmic track.
double stepped(const NumberScale& scale, double value, int steps);
/// Returns the text of a number.
std::string written(const NumberScale& scale, double value);
/// Returns the number that a text means; nothing if it is no number.
std::optional<double> meant(const NumberScale& scale, const std::string& text);

}  // namespace throng::app
