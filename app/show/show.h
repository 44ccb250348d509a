#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/settings/settings.h"
#include "app/show/camera_guide.h"
#include "app/show/figures/run_figures.h"
#include "app/show/painter.h"
#include "app/show/recording/recorder.h"
#include "app/show/request/request.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "app/show/stage/stage_requests.h"
#include "app/show/starting_characters.h"
#include "app/show/viewer/viewer.h"
#include "engine/render/camera.h"
#include "engine/tracks/live/live_crowd.h"

namespace throng::app {

class StartLine;

/// Joins a crowd, the painter that draws it and the figures of the run: the demo without a loop, in a window or without
/// one.
class Show {
 public:
  /// `live` has a head, and is there where the options name standard input.
  static std::unique_ptr<Show> create(const DemoOptions& options, StartError& error,
                                      std::unique_ptr<LiveTracks> live = {});

  /// Takes a request at a frame boundary, and records it; nothing else changes the crowd. Another scene brings its own
  /// camera, and other characters begin the crowd anew. Errors: it cannot be done; then nothing has changed.
  anim::Status take(const CrowdRequest& request);
  /// Gives all agents other characters, 1 to most_models, as SetCast does with characters that are loaded already.
  anim::Status replace_characters(std::vector<CharacterSource> characters);
  /// Shows a recorded crowd in place of all agents, with the characters that are there, at a frame boundary. It begins
  /// at its first row, is repeated, and the scene `tracks` brings its camera. Errors: the show is recorded, or memory
  /// lacks; then nothing has changed.
  anim::Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories);

  /// Keeps moments of the crowd from now on, but for frames in which it pauses; that takes memory. A recording and its
  /// replay keep the same ones.
  void keep_moments() { keeps_moments_ = true; }
  const Rewind& moments() const { return rewind_; }

  /// Moves and poses one frame of `delta`; 0 while paused.
  void animate(anim::Ticks delta) { update(delta, nullptr); }
  /// Repeats a frame as it was recorded: seen by that camera, in a picture of that size.
  void animate_as(const RecordedFrame& frame);
  /// Draws the frame that was animated last. Errors: those of Painter::draw.
  anim::Status draw();
  /// Draws which agent is where in the frame that was animated last, whether it was drawn or not. Errors: those of
  /// render::Renderer::draw_labels.
  anim::Status draw_labels(bool is_drawn, render::LabelPicture& labels);

  /// Shows one character alone from now on: animate() and draw() are about it, and the crowd waits as it is. Errors:
  /// those of Viewer::create; then nothing has changed.
  anim::Status view(const ViewRequest& request);
  void leave_viewer() { viewer_.reset(); }
  /// Returns the viewer of a character alone; null while the crowd is shown. It ends when a character's bones or parts
  /// of the body change, and shows the first of other characters when they come.
  Viewer* viewer() const { return viewer_.get(); }

  /// Begins the crowd and every clock anew with these values, as on a show just made. Errors: those of take(); then
  /// nothing has changed.
  anim::Status begin_anew(const Tuning& tuning);

  /// Records from now on what the show is asked for, and the poses that come of it. A crowd that has moved begins anew,
  /// so that a replay can begin where this does; moments are kept. Errors: the file cannot be written; the scene is
  /// `tracks`, which a recording neither begins with nor comes to.
  anim::Status start_recording(const std::filesystem::path& file);
  /// Ends the recording, if there is one. Errors: the file could not be written.
  anim::Status stop_recording() { return recorder_.stop(); }
  /// Returns the recorder, which says whether a recording goes on and why the last one had to end.
  const Recorder& recorder() const { return recorder_; }

  /// Returns the crowd whose rows still come; null where there is none.
  const LiveCrowd* live() const { return live_.get(); }
  /// Waits, at most `most`, for the rows that a frame of a live crowd shows. Returns whether they are there; the rows
  /// of other crowds always are.
  bool has_rows_for(anim::Ticks step, std::chrono::milliseconds most);

  const Stage& stage() const { return *stage_; }
  Painter& painter() { return *painter_; }
  const Painter& painter() const { return *painter_; }
  RunFigures& figures() { return figures_; }
  const RunFigures& figures() const { return figures_; }

  render::Camera camera;
  bool films = false;  ///< a camera path or the camera of a cut scene sets `camera` in each frame, where there is one
  CameraGuide guide;   ///< moves `camera` where no person flies it
  int width = 0;
  int height = 0;
  float covered = 0.0F;  ///< share of the picture's width, at its right, that a panel hides from the viewer
  /// Tells people in lines what they would not expect (app/show/figures/notices.h); may be empty.
  std::string notice;

 private:
  Show() = default;
  bool open_stage(std::vector<CharacterSource> characters, const DemoOptions& options, StartLine& line,
                  StartError& error);
  bool open_live(const DemoOptions& options, std::unique_ptr<LiveTracks> live, StartError& error);
  bool begin_tracks(const DemoOptions& options, StartError& error);
  void take_live_rows(anim::Ticks step);
  bool place_camera(const DemoOptions& options, StartError& error);
  bool follow_from_start(const std::string& name, const DemoOptions& options, StartError& error);
  anim::Status carry_out(const Apply& values);
  anim::Status carry_out(const SetBody& body);
  anim::Status carry_out(const SetBones& bones);
  anim::Status carry_out(const SetPlacement& placement);
  anim::Status carry_out(const LoadModels& models);
  anim::Status carry_out(const SetCast& cast);
  anim::Status carry_out(const GoBack& back);
  template <typename OfStage>
  anim::Status carry_out(const OfStage& asked) {
    return app::carry_out(asked, *stage_);
  }
  CrowdRequest as_recorded(const CrowdRequest& request) const;
  anim::Status cast(anim::Result<LoadedCast> loaded);
  anim::Status exchange(std::vector<CharacterSource> characters, const Tuning& tuning,
                        std::shared_ptr<const Trajectories> trajectories);
  bool begin_viewing(const std::string& clip, StartError& error);
  void update_notice();
  void freeze_lod_camera();
  void update(anim::Ticks delta, const LodView* as_recorded);  // null: as the show is seen now

  std::unique_ptr<Painter> painter_;
  std::unique_ptr<Stage> stage_;     // goes before the painter, as it uses the painter's pages
  std::unique_ptr<LiveCrowd> live_;  // null: no rows come
  std::size_t live_news_ = 0;
  std::unique_ptr<Viewer> viewer_;  // null: the crowd is shown; goes before the stage, as it uses the stage's slots
  Recorder recorder_;
  RunFigures figures_;
  Rewind rewind_;
  LoadOptions load_options_;           // of models that are dropped too
  std::string data_;                   // the folder that --data names
  std::vector<std::string> left_out_;  // of the files that were named or dropped
  bool keeps_moments_ = false;
  std::optional<render::Camera> frozen_camera_;
};

}  // namespace throng::app
