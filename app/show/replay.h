#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/recording/reader.h"
#include "app/settings/settings.h"
#include "app/show/show.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Repeats a recording and compares the poses:
///     show = Show::create(replay->options(given)); replay->begin(show); while (replay->step(show)) draw
class Replay {
 public:
  /// Opens a recording. Errors: those of RecordingReader::open.
  static anim::Result<std::unique_ptr<Replay>> open(const std::filesystem::path& file);

  /// Returns the options of the command line, completed by what was recorded. PUs, local store, tile, schedule and
  /// double buffer keep the values of the command line throughout, because poses do not depend on them.
  DemoOptions options(const DemoOptions& given);

  /// Prepares the show for the first frame. It gets characters with the recorded roles and orders of bones where its
  /// own differ. Errors: the characters are not those that were recorded.
  anim::Status begin(Show& show) const;

  /// Repeats what was asked for, then a frame. Returns false when no frame is left. Errors: the first frame and agent
  /// that differ; the recording is cut short or damaged.
  anim::Result<bool> step(Show& show);

  /// Returns "run.rec: all 120 frames are equal, the last of 300 agents".
  std::string summary() const;

 private:
  Replay(std::filesystem::path file, std::unique_ptr<RecordingReader> reader)
      : file_(std::move(file)), reader_(std::move(reader)) {}

  Tuning with_own_scheduling(Tuning tuning) const;
  RecordedRequest with_own_scheduling(RecordedRequest request) const;
  anim::Status compare(const RecordedFrame& frame, const Stage& stage) const;

  std::filesystem::path file_;
  std::unique_ptr<RecordingReader> reader_;
  DemoOptions given_;
  std::size_t agents_ = 0;  // of the last frame
};

}  // namespace throng::app
