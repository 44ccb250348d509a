#pragma once

#include <string>

#include "app/report/selection_report.h"

namespace throng::app {

/// "0.42 / 1.03": seconds of a player in its clip; empty for what plays none.
std::string place_in_clip(const EntityRow& row);

/// "25 %", of a weight of 0 to 1.
std::string as_percent(float weight);

}  // namespace throng::app
