#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "throng/render/image.h"

#include "engine/base/files/output_file.h"
#include "engine/base/files/piped_program.h"
#include "engine/base/result.h"

namespace throng::app {

/// Says the size and rate of a video.
struct VideoFormat {
  int width = 0, height = 0;  ///< pixels, even
  double rate = 60;           ///< frames a second
};

/// Checks that an ffmpeg is installed that can make a video of this name. Errors: it is missing, with the package that
/// has it; it lacks the encoder.
Status check_encoder(const std::filesystem::path& file);

/// A video that an ffmpeg makes of frames: H.264 in .mp4, VP9 in .webm. The file is whole, or stays as before.
class VideoFile {
 public:
  /// Errors: ffmpeg does not start, or the file cannot be written.
  static Result<std::unique_ptr<VideoFile>> create(const std::filesystem::path& file, const VideoFormat& format);

  /// Adds a frame, which has the size of the video. Errors: ffmpeg ended; the error has its last words.
  Status add(const render::Image& frame);
  /// Ends the video, and gives the file its name. Errors: ffmpeg failed, the disk is full, or the video has no end,
  /// whatever the exit status of ffmpeg.
  Status finish();

 private:
  VideoFile(OutputFile file, PipedProgram encoder, const VideoFormat& format);
  Error ended(const std::string& how, int status) const;

  OutputFile file_;
  PipedProgram encoder_;
  std::vector<std::byte> rgb_;  // of a frame
};

}  // namespace throng::app
