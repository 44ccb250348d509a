#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/show/request/requests.h"
#include "app/window/dropped_tracks.h"
#include "app/window/file_requests.h"
#include "app/window/panel/overlay.h"
#include "app/window/video_job.h"
#include "app/window/window_session.h"

namespace throng::app {

/// Takes the requests of a person at a window, in order, at a frame boundary, and says what came of them.
class WindowRequests {
 public:
  WindowRequests(WindowSession& session, Overlay& overlay)
      : session_(session), overlay_(overlay), files_(session, overlay) {}

  void take(const Requests& requests);
  /// Returns whether the window is to be closed.
  bool closes() const { return closes_; }
  /// Carries out requests for the picture, once it is drawn.
  void take_after_drawing(const Requests& requests);
  /// Ends what goes on beside the window.
  void end_jobs() { video_.end(); }
  /// Takes the parts of a crowd file that only a window keeps.
  void take_kept(const CrowdSetup& setup) { files_.take_kept(setup); }

 private:
  void take(const CrowdRequest& request);
  void take(const WindowRequest& request);
  void take(const FrameRequest& request) {
    closes_ |= std::holds_alternative<Quit>(request);
  }  // the loop does the rest
  void take(const FileRequest& request) { files_.take(request); }
  void take(const CameraRequest& request);
  void take(const ViewerRequest& request);
  void take(const ReplayRequest& /*request*/) {}  // there is no replay
  void carry_out(const SelectAt& asked);
  void carry_out(const OpenFiles& asked);
  void carry_out(const Undo& asked);
  void carry_out(const Redo& asked);
  void carry_out(const Tell& asked) { messages().say(asked.words, Message::Kind::refused); }
  void carry_out(const ToggleRecording& asked);
  void carry_out(const CopyCamera& asked);
  void carry_out(const CopyCommandLine& asked);
  void carry_out(const ReloadShaders& asked);
  void carry_out(const ShowCharacter& asked);
  void carry_out(const TuneRules& asked);
  void carry_out(const StartSweep& asked);
  void carry_out(const StopSweep& /*asked*/) { session_.sweep.stop(); }
  void carry_out(const LookAtFrame& asked) { session_.reporter.look_at(asked.frame); }
  void carry_out(const LookAtLastFrames& /*asked*/) { session_.reporter.look_at_last(); }
  void carry_out(const FrameCrowd& /*asked*/) { session_.camera.frame_crowd(session_.show); }
  void carry_out(const LeaveUnsaved& asked);
  void carry_out(const KeepWorking& asked);
  void carry_out(const CancelJob& asked);
  void carry_out(const MakeVideo& asked);
  void carry_out(const SetOutput& asked);
  void take_at_once(const Request& request);
  void open_models(const std::vector<std::string>& files);
  bool make(const CrowdRequest& request);
  void go_on_leaving();
  void report_jobs();
  void copy(const std::string& options);
  void take_screenshot();
  void announce_still();
  void draw_still();
  Messages& messages() { return session_.messages(); }

  WindowSession& session_;
  Overlay& overlay_;
  FileRequests files_;
  VideoJob video_;
  std::optional<Request> leaving_;  // waits for the person's answer about unsaved work
  bool closes_ = false;
  bool shows_b_ = false;  // of two tunings
  std::string still_;     // the file of the still that is drawn next; empty: none
  int screenshots_ = 0;
  int videos_ = 0;
  int recordings_ = 0;
};

}  // namespace throng::app
