#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/output/label_files.h"
#include "app/output/output_folder.h"
#include "app/output/video_file.h"
#include "app/output/workers.h"
#include "app/settings/settings.h"
#include "app/show/show.h"

namespace throng::app {

/// Checks, before anything is loaded, that the other programs that an output needs are there. Errors: as
/// check_encoder().
Status check_output(const OutputOptions& options);

/// Returns how many frames a run has: as options ask; else to the end of a recorded crowd that is written. Returns 0
/// where the rows of a live crowd still come, or a recording says it, since their number is unknown.
int frames_of_run(const DemoOptions& options, const Show& show);

/// Writes a video, pictures and labels of each frame of a run. Drawing goes on while frames are encoded. A frame whose
/// files an earlier part of the same run has written is not drawn again.
class Output {
 public:
  /// Errors: a file or folder cannot be written, or belongs to another run.
  static Result<std::unique_ptr<Output>> begin(const DemoOptions& options, const Show& show);

  /// Calls `draw` over each picture of a frame; labels do not show it. Its error ends the run.
  void draw_over_pictures(std::function<Status(Show& show)> draw) { draw_over_ = std::move(draw); }

  /// Takes the frame that the show animated last, counted from 1; draws it unless its files are there. Errors: it
  /// cannot be drawn, or one of the frames before could not be written.
  Status take(Show& show, int frame);
  /// Returns whether the show's picture is of the last frame.
  bool drew_last() const { return drew_last_; }
  /// Waits until all is written, and ends the video. Errors: a file could not be written.
  Status finish();
  /// Lists what is written: "crowd.mp4 (1.0 s of video, 2.1 MB)", "pictures (60 pictures)".
  std::vector<std::string> written() const;

 private:
  using SharedImage = std::shared_ptr<const render::Image>;

  explicit Output(const DemoOptions& options);
  Status open_files(const DemoOptions& options, const Show& show);
  bool is_there(int frame) const;
  Status draw(Show& show, int frame);
  Status keep_image(Show& show, int frame);
  Status use_again(int frame);
  Status add_to_video(SharedImage image);

  OutputOptions options_;
  std::function<Status(Show& show)> draw_over_;  // may be empty
  VideoFormat format_;
  std::optional<OutputFolder> pictures_;
  std::unique_ptr<LabelFiles> labels_;
  std::unique_ptr<VideoFile> video_;
  int frames_ = 0, kept_ = 0;
  bool drew_last_ = false;                            // in colour
  std::optional<Workers> encoder_, picture_writers_;  // go first, as they use all members
};

}  // namespace throng::app
