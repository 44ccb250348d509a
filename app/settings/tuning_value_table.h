#pragma once

#include <vector>

#include "app/settings/tuning_values.h"

namespace throng::app {

/// Makes the table that tuning_values() keeps. A new member of Tuning gets a row there.
std::vector<TuningValue> tuning_value_table();

/// Returns the rows of sun, sky and shadows, which are a part of the table.
std::vector<TuningValue> light_values();
/// Returns the rows of colours, their scales, trails and bones, another part.
std::vector<TuningValue> view_values();

}  // namespace throng::app
