#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/stage/posed_feet.h"

namespace throng::app {

/// A stage on which the built-in character plays the people of a recorded crowd.
class TracksStage : public testing::Test {
 protected:
  TracksStage(std::shared_ptr<const Trajectories> people, const CameraPose& seen_from, Ticks frame)
      : camera_(camera_at(seen_from)), people_(std::move(people)), frame_(frame) {}

  /// Begins anew, in the scene of the tuning.
  void open(const Tuning& tuning) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    stage_.reset();
    pages_ = std::make_unique<KeptPages>();
    auto made = Stage::create(std::move(characters), tuning, *pages_, 0, people_);
    ASSERT_TRUE(made) << made.error().message;
    stage_ = std::move(*made);
  }
  void pass(int frames) { pass(frames, frame_); }
  void pass(int frames, Ticks step) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(step);
      stage_->pose(camera_, 1280, 720, step, stage_->posed().frame());
    }
  }
  double seconds() const { return stage_->crowd().tracks()->clock().seconds; }
  void go_to(double seconds) {
    TrackClock clock = stage_->crowd().tracks()->clock();
    clock.seconds = seconds;
    stage_->set_track_clock(clock);
  }

  render::Camera camera_;
  std::unique_ptr<KeptPages> pages_;  // of the stage that is open
  std::unique_ptr<Stage> stage_;
  std::shared_ptr<const Trajectories> people_;

 private:
  Ticks frame_;
};

}  // namespace throng::app
