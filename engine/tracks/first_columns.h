#pragma once

#include <string_view>

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

}  // namespace throng
