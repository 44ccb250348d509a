#pragma once

#include <optional>
#include <string_view>

#include "engine/tracks/text/table_layout.h"

namespace throng {

/// Holds what the first rows of a table show of its times.
struct RoundedTimes {
  bool are_rounded = false;         ///< frames of a person follow each other at one time
  std::optional<double> rate = {};  ///< frames a second, as far as the rounded times show it
};

/// Looks at the first rows of a table, which has a column of frames beside its column of times.
RoundedTimes rounded_times_of(std::string_view rows, const TableLayout& layout);

}  // namespace throng
