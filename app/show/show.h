#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "throng/ticks.h"

#include "app/show/request/request.h"
#include "engine/base/result.h"

namespace throng {
class LiveCrowd;
struct Trajectories;
}  // namespace throng
namespace throng::render {
struct LabelPicture;
}

namespace throng::app {

class Painter;
class Recorder;
class Rewind;
class RunFigures;
class Stage;
class Viewer;
struct CharacterSource;
struct LoadPlan;
struct LoadedCast;
struct LodView;
struct RecordedFrame;
struct ShowParts;
struct ShowView;
struct ViewRequest;

/// Joins a crowd, the painter that draws it and the figures of the run: the demo without a loop, in a window or without
/// one. open_show() makes it (opened_show.h).
class Show {
 public:
  explicit Show(std::unique_ptr<ShowParts> parts);
  ~Show();
  Show(const Show&) = delete;
  Show& operator=(const Show&) = delete;

  /// Takes a request at a frame boundary, and records it; nothing else changes the crowd. Another scene brings its own
  /// camera, and other characters begin the crowd anew. Errors: it cannot be done; then nothing has changed.
  Status take(const CrowdRequest& request);
  /// Gives all agents other characters, 1 to most_models, as SetCast does with characters that are loaded already.
  Status replace_characters(std::vector<CharacterSource> characters);
  /// Returns the plan to load, ahead of them, what requests bring from files.
  LoadPlan plan_for(std::span<const CrowdRequest> requests) const;
  /// Takes characters that were loaded for the next requests that bring some, in their order. Characters that were
  /// loaded for requests that did not come are given up.
  void take_ahead(std::deque<LoadedCast> casts);
  /// Shows a recorded crowd in place of all agents, with the characters that are there, at a frame boundary. It begins
  /// at its first row, is repeated, and the scene `tracks` brings its camera. Null forgets the recorded crowd that was
  /// there, while another scene is shown. Errors: the show is recorded, or memory lacks; then nothing has changed.
  Status replace_trajectories(std::shared_ptr<const Trajectories> trajectories);

  /// Takes the recorded crowd to the moment, and the camera to the place, with which a run of these options begins.
  /// Errors: the file has no such time, or the crowd has no such camera or person.
  Status begin_as(const DemoOptions& options);

  /// Keeps moments of the crowd from now on, but for frames in which it pauses; that takes memory. A recording and its
  /// replay keep the same ones.
  void keep_moments();
  const Rewind& moments() const;

  /// Moves and poses one frame of `delta`; 0 while paused.
  void animate(Ticks delta) { update(delta, nullptr); }
  /// Repeats a frame as it was recorded: seen by that camera, in a picture of that size.
  void animate_as(const RecordedFrame& frame);
  /// Draws the frame that was animated last. Errors: those of Painter::draw.
  Status draw();
  /// Draws which agent is where in the frame that was animated last, whether it was drawn or not. Errors: those of
  /// render::Renderer::draw_labels.
  Status draw_labels(bool is_drawn, render::LabelPicture& labels);
  /// Returns the agent that is seen at a pixel from the top left of the picture drawn last; nothing where there is
  /// none.
  std::optional<std::uint32_t> agent_at(float x, float y) const;

  /// Shows one character alone from now on: animate() and draw() are about it, and the crowd waits as it is. Errors:
  /// those of Viewer::create; then nothing has changed.
  Status open_viewer(const ViewRequest& request);
  void leave_viewer();
  /// Returns the viewer of a character alone; null while the crowd is shown. It ends when a character's bones or parts
  /// of the body change, and shows the first of other characters when they come.
  Viewer* viewer() const;

  /// Begins the crowd and every clock anew with these values, as on a show just made. Errors: those of take(); then
  /// nothing has changed.
  Status begin_anew(const Tuning& tuning);

  /// Records from now on what the show is asked for, and the poses that come of it. A crowd that has moved begins anew,
  /// so that a replay can begin where this does; moments are kept. Errors: the file cannot be written; the scene is
  /// `tracks`, which a recording neither begins with nor comes to.
  Status start_recording(const std::filesystem::path& file);
  /// Ends the recording, if there is one. Errors: the file could not be written.
  Status stop_recording();
  /// Returns the recorder, which says whether a recording goes on and why the last one had to end.
  const Recorder& recorder() const;

  /// Returns the crowd whose rows still come; null where there is none.
  const LiveCrowd* live() const;
  /// Waits, at most `most`, for the rows that a frame of a live crowd shows. Returns whether they are there; the rows
  /// of other crowds always are.
  bool has_rows_for(Ticks step, std::chrono::milliseconds most);

  const Stage& stage() const;
  Painter& painter();
  const Painter& painter() const;
  RunFigures& figures();
  const RunFigures& figures() const;
  /// Tells people in lines what they would not expect (app/show/figures/notices.h); may be empty.
  const std::string& notice() const { return notice_; }
  /// Returns the camera and the picture.
  ShowView& view();
  const ShowView& view() const;

 private:
  void take_live_rows(Ticks step);
  void update(Ticks delta, const LodView* as_recorded);  // null: as the show is seen now

  std::unique_ptr<ShowParts> parts_;
  std::string notice_;
  std::size_t live_news_ = 0;
};

}  // namespace throng::app
