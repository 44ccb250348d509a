#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"

namespace throng::app::test {

/// A stage, of the built-in character where no others are given, that a camera sees whole, and that may go back in
/// time.
class WatchedStage : public testing::Test {
 protected:
  static constexpr Ticks frame = ticks_per_second / 60;

  void open(const Tuning& tuning) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    open(tuning, std::move(characters));
  }
  void open(const Tuning& tuning, std::vector<CharacterSource> characters) {
    auto made = Stage::create(std::move(characters), tuning, pages_);
    ASSERT_TRUE(made);
    stage_ = std::move(*made);
  }

  void pass(int frames) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(frame);
      stage_->pose(camera_, 1280, 720, frame, stage_->posed().frame());
      rewind_.watch(*stage_);
    }
  }
  std::uint64_t hash() const { return stage_->system().figures().pose_hash(); }

  HeapPageSource pages_{std::size_t{1} << 20U};
  std::unique_ptr<Stage> stage_;
  Rewind rewind_;
  render::Camera camera_ = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
};

}  // namespace throng::app::test
