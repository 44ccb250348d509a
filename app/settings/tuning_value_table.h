#pragma once

#include <vector>

#include "app/settings/tuning_values.h"

namespace throng::app {

/// Makes the table that tuning_values() keeps. A new member of Tuning gets a row there.
std::vector<TuningValue> tuning_value_table();

}  // namespace throng::app
