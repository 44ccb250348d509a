#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/lod/lod_thresholds.h"
#include "app/stage/stage.h"

namespace throng::app {

/// Where the interval changes around the camera that level of detail looks from. By distance that is the same for all;
/// by the error in pixels it is another one for each clip, so it is told for the clip that most of those in view play.
class ThresholdsInView {
 public:
  /// After each frame was posed, seen in a picture of `height` pixels.
  void update(const Stage& stage, const render::Camera& lod_camera, int height);

  const std::vector<IntervalThreshold>& thresholds() const { return thresholds_; }
  /// Of which clip; empty: of all alike.
  const std::string& clip() const { return clip_name_; }
  std::size_t character() const { return character_; }

 private:
  void pick_clip(const Stage& stage);

  std::vector<IntervalThreshold> thresholds_;
  std::vector<std::vector<int>> agents_;  // [character][clip + 1], 0: stands still
  std::size_t character_ = 0;
  int clip_ = no_clip;
  std::string clip_name_;
};

}  // namespace throng::app
