#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/show/recording/reader.h"
#include "engine/base/result.h"

namespace throng::app {

class Show;
class Stage;
struct CharacterSource;

/// Repeats a recording and compares the poses:
///     show = open_show(replay->options(given)); replay->begin(show); while (replay->step(show)) draw
class Replay {
 public:
  /// Opens a recording. Errors: those of RecordingReader::open.
  static Result<std::unique_ptr<Replay>> open(const std::filesystem::path& file);

  /// Returns the options of the command line, completed by the recorded ones. Values that only schedule
  /// come from the command line throughout.
  DemoOptions options(const DemoOptions& given);

  /// Prepares the show for the first frame. It gets characters with the recorded roles and orders of bones where its
  /// own differ. Errors: the characters are not the recorded ones.
  Status begin(Show& show) const;

  /// Repeats the recorded requests, then a frame. Returns false if no frame is left. Errors: the first frame and agent
  /// that differ; the recording is cut short or damaged.
  Result<bool> step(Show& show);

  /// Goes back to before the first frame, if allow_to_go_back() was called before the first. Errors: those of begin().
  Status begin_anew(Show& show);

  /// Keeps what begin_anew() needs.
  void allow_to_go_back() { may_go_back_ = true; }

  std::uint64_t frame() const { return reader_->frames_read(); }    ///< the frame that was repeated last; 0: none
  std::uint64_t count_frames() { return reader_->count_frames(); }  ///< frames of the file, which it reads over
  Ticks delta() const { return delta_; }                            ///< the time of the frame that was repeated last

  /// Returns "run.rec: all 120 frames are equal, the last of 300 agents".
  std::string summary() const;

 private:
  Replay(std::filesystem::path file, std::unique_ptr<RecordingReader> reader)
      : file_(std::move(file)), reader_(std::move(reader)) {}

  Tuning with_own_scheduling(Tuning tuning) const;
  CrowdRequest with_own_scheduling(CrowdRequest request) const;
  Status become_recorded_characters(Show& show, std::span<const CharacterSource> people) const;
  Status compare(const RecordedFrame& frame, const Stage& stage) const;

  std::filesystem::path file_;
  std::unique_ptr<RecordingReader> reader_;
  DemoOptions given_;
  std::uint64_t frames_equal_ = 0;  // without the frames that were repeated again
  std::size_t agents_ = 0;          // of the last equal frame
  Ticks delta_{};
  bool may_go_back_ = false;
  std::vector<CharacterSource> first_people_;  // before other characters came; empty: none have
};

}  // namespace throng::app
