#pragma once

namespace throng::app {

/// What a person at a window chose for the files that it writes.
struct OutputChoices {
  int picture_times = 1;        ///< a picture without the panel has so many times the window's width and height
  double video_seconds = 10.0;  ///< of a video from now on

  friend bool operator==(const OutputChoices&, const OutputChoices&) = default;
};

inline constexpr int most_picture_times = 4;
inline constexpr double least_video_seconds = 1, most_video_seconds = 600;

}  // namespace throng::app
