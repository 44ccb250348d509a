#pragma once

#include <optional>
#include <string>
#include <vector>

namespace throng::app {

inline constexpr int most_labelled_agents = 65534;  ///< an id mask has 16 bits; 0 is no person

/// Says what a headless run writes of each of its frames (app/output/README.md).
struct OutputOptions {
  std::string video;                        ///< FILE.mp4 or FILE.webm; empty: none
  std::string pictures, labels;             ///< folders; empty: none
  std::optional<double> frames_per_second;  ///< of the video; unset: it plays as fast as the run's time goes
  std::optional<double> seconds;            ///< the run's time; unset: DemoOptions::frames says its length
  std::vector<std::string> run;             ///< the words of the command line that decide the pictures

  bool any() const { return !video.empty() || !pictures.empty() || !labels.empty(); }
};

}  // namespace throng::app
