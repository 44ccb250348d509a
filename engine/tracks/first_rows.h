#pragma once

#include <optional>
#include <string_view>

#include "engine/tracks/text/table_layout.h"

namespace throng {

/// Says which of the first two columns of rows without names is the frame.
struct FirstColumns {
  bool frame_is_first = false;  ///< frame, id, x, y; else id, frame, x, y
  bool counts_frames = true;    ///< else it has seconds
  bool skips_frames = false;    ///< a person's rows are further apart than one frame
};

/// Tells by rows of at least four numbers which of the first two is the frame: with the right one, a person's rows
/// follow each other at even times, and near each other. Where both fit, the id is first.
FirstColumns first_columns_of(std::string_view rows, char separator);

/// Holds what the first rows of a table show of its times.
struct RoundedTimes {
  bool are_rounded = false;         ///< frames of a person follow each other at one time
  std::optional<double> rate = {};  ///< frames a second, as far as the rounded times show it
};

/// Looks at the first rows of a table, which has a column of frames beside its column of times.
RoundedTimes rounded_times_of(std::string_view rows, const TableLayout& layout);

}  // namespace throng
