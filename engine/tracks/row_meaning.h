#pragma once

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Holds what the file's numbers mean, once it is known.
struct RowScale {
  double times_a_second = 1.0;  ///< seconds, milliseconds or frames
  double metres_a_unit = 1.0;
  AngleMeaning angle = AngleMeaning::none;  ///< never unknown
  bool z_is_head = false;
  bool has_heights = true;  ///< false: z is left out
};

/// Returns what the file's angles mean; the options overrule the file.
AngleMeaning angle_asked(AngleMeaning of_file, TrackAngle asked);

/// Returns how many units of time are a second, where rows have times.
double times_a_second(const RowFacts& facts, const TrackReading& options);

/// Finds values that neither the file nor the options say, by how people move and by their heights, and adds the
/// findings to facts.remarks. Rows have numbers of tables.front(). The error is the end of a sentence.
Result<RowScale> tell_apart(RawTracks& tracks, const TrackReading& options);

}  // namespace throng
