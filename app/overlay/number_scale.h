#pragma once

#include <optional>
#include <string>

#include "app/overlay/widgets.h"

namespace throng::app {

/// The nearest number that the scale accepts.
double accepted(const NumberScale& scale, double value);
/// Where a number lies along its track, 0 to 1, and back.
double place_of(const NumberScale& scale, double value);
double value_at(const NumberScale& scale, double place);
/// How a number is written, and what a text means: nothing if it is no number.
std::string written(const NumberScale& scale, double value);
std::optional<double> meant(const NumberScale& scale, const std::string& text);

}  // namespace throng::app
