#pragma once

#include <memory>

#include "throng/render/image.h"

#include "app/output/kept_lines.h"
#include "app/output/label_frame.h"
#include "app/output/output_folder.h"
#include "app/output/workers.h"
#include "app/settings/settings.h"
#include "app/show/show.h"
#include "engine/base/files/output_file.h"

namespace throng::app {

/// Writes labels of each frame into a folder: mask_000001.png, depth_000001.png, a line of labels.jsonl, and
/// labels.json, which has what all lines share.
class LabelFiles {
 public:
  /// Errors: as OutputFolder::open(), memory does not hold the labels, or a file cannot be written.
  static Result<std::unique_ptr<LabelFiles>> open(const DemoOptions& options, const Show& show);

  /// Returns whether an earlier part of the run has written the files of a frame.
  bool has(int frame) const;
  /// Takes the frames one after the other, from the first. Errors: as LabelMaker::make(), or one of the frames before
  /// could not be written.
  Status take(Show& show, int frame, bool is_drawn);
  /// Passes over a frame that is there. Errors: one of the frames before could not be written.
  Status keep();
  /// Ends labels.jsonl.
  Status finish();

 private:
  LabelFiles(OutputFolder folder, OutputFile lines, const Stage& stage, glm::ivec2 size);
  Status write(const LabelFrame& frame, const render::NumberImage& mask, const render::NumberImage& depth);

  OutputFolder folder_;
  glm::ivec2 size_;
  KeptLines kept_;
  OutputFile lines_;
  LabelMaker maker_;
  Workers writer_;  // last, as its jobs use all of it
};

}  // namespace throng::app
