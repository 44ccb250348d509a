#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/show/report/job_report.h"
#include "app/show/request/crowd_file.h"
#include "engine/base/files/piped_program.h"

namespace throng::app {

struct WindowSession;

/// A video that a run without a window makes of a setup.
struct WantedVideo {
  std::string file;
  glm::ivec2 size{0};  ///< of a window, in pixels
  CrowdSetup setup;
  double seconds = 0.0;        ///< of the video; a recorded crowd plays its part instead
  double crowd_seconds = 0.0;  ///< for which the crowd goes on, unseen, before; a recorded crowd leaves that out
};

/// Returns the options of that run. `options` are those of the window. The video has 30 frames a second, and the crowd
/// goes at the speed of the window's clock. A recorded crowd plays its part once, from its beginning as it is played.
std::vector<std::string> words_of_video(WantedVideo video, const DemoOptions& options);

/// How far a run is, as `--progress` says it.
struct VideoProgress {
  std::string words;    ///< empty: it has no frame yet
  double share = -1.0;  ///< of its frames, 0 to 1; below 0: not known
};
/// Finds the newest progress among all that a run said on standard error.
VideoProgress progress_in(const std::string& said);

/// Makes a video of what is open while the window goes on: by this program once more, in a process of its own that
/// gives way to the window.
class VideoJob {
 public:
  /// Begins the video, or says why it cannot be made.
  void begin(WindowSession& session, CrowdSetup setup, const std::string& file);
  /// Ends it. The frames so far are a whole video; before the first one there is no file.
  void cancel();
  /// Says what came of it, once it has ended. Call it once a frame.
  void go_on(WindowSession& session);
  std::optional<JobReport> report() const;
  /// Ends it with the window, and waits for the frames so far.
  void end();

 private:
  void say_outcome(WindowSession& session, int status);
  bool has_frames() const { return !progress_in(program_->answer()).words.empty(); }

  std::optional<PipedProgram> program_;  // none: no video is made
  std::string file_;
  bool ends_ = false, leaves_no_file_ = false;
};

}  // namespace throng::app
