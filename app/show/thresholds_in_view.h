#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "throng/render/camera.h"

#include "app/show/lod/lod_thresholds.h"

namespace throng::app {

class Stage;

/// The distances from the camera of level of detail where the interval changes. By the distance rule they are the same
/// for all agents. By the error in pixels they differ from clip to clip, so they hold for the clip that most agents in
/// view play.
class ThresholdsInView {
 public:
  /// Finds the distances for the frame that was posed, seen in a picture of `height` pixels. Call it after each frame.
  void update(const Stage& stage, const render::Camera& lod_camera, int height);

  const std::vector<IntervalThreshold>& thresholds() const { return thresholds_; }
  /// Returns the clip that the distances hold for; empty if they hold for all clips.
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
