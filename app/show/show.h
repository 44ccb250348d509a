#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/figures/limiter.h"
#include "app/figures/notices.h"
#include "app/figures/statistics.h"
#include "app/figures/timeline_log.h"
#include "app/recording/writer.h"
#include "app/settings/settings.h"
#include "app/show/lod_view.h"
#include "app/show/picture.h"
#include "app/show/thresholds_in_view.h"
#include "app/stage/rewind.h"
#include "app/stage/stage.h"
#include "engine/render/camera.h"
#include "engine/render/gl/context.h"
#include "engine/render/renderer.h"

namespace throng::app {

/// Ends a run before it begins, with this exit status.
struct StartError : anim::Error {
  int status = 1;
};

/// A crowd, what draws it, and the figures: the demo without a loop, in a window or without one.
class Show {
 public:
  static std::unique_ptr<Show> create(const DemoOptions& options, StartError& error);
  ~Show();

  /// New values at a frame boundary; the sentence if they cannot be, and then nothing has changed.
  anim::Status apply(const Tuning& tuning);

  /// Other characters for everyone, a file each, at a frame boundary; the crowd starts anew. On error, which names the
  /// file, nothing has changed.
  anim::Status replace_models(std::span<const std::string> files);

  /// The same with characters that are loaded already, 1 to most_models.
  anim::Status replace_characters(std::vector<CharacterSource> characters);

  /// Other clips for the roles of a character, at a frame boundary.
  void set_roles(std::size_t character, const RoleClips& clips);
  /// Keeps a character's roles for the next time; where, to tell people.
  anim::Result<std::filesystem::path> save_roles(std::size_t character) const;

  /// As Stage::set_bone_lod, and what is drawn with it.
  anim::Status set_bone_lod(std::size_t character, const BoneLodChoice& choice);
  /// Keeps the order of a character's bones for the next time; where, to tell people.
  anim::Result<std::filesystem::path> save_bone_lod(std::size_t character) const;

  /// Writes a character's level of detail for another engine, beside the model or among a person's files; where.
  anim::Result<std::filesystem::path> export_lod(std::size_t character) const;

  /// Selects whoever is seen at a pixel from the top left of the picture drawn last; nobody there deselects.
  void select_at(float x, float y);
  void select(std::optional<std::uint32_t> agent);
  void deselect() { select({}); }
  /// Pushes the selected agent over, away from the camera. Errors as Stage::push_over; nothing if nobody is selected.
  anim::Status push_selected();
  /// Errors as Stage::push_over.
  anim::Status push(std::uint32_t agent, const glm::vec3& direction);

  /// From where level of detail and culling look: `camera`, or where that was when it was frozen.
  const render::Camera& lod_camera() const { return frozen_camera_ ? *frozen_camera_ : camera; }

  /// As Stage::hold_clip.
  void hold_clip(std::uint32_t agent, float seconds);
  void hold_selected_clip(float seconds);  ///< nothing if nobody is selected
  void let_go_of_clip();

  /// From now on moments of the crowd are kept, but for frames in which it pauses; that takes memory. A recording and
  /// its replay keep the same ones.
  void keep_moments() { keeps_moments_ = true; }
  /// Takes the crowd back to the newest moment, each time further. Errors as Rewind::go_back.
  anim::Status rewind();
  const Rewind& moments() const { return rewind_; }

  /// Moves and poses one frame of `delta`; 0 while paused.
  void animate(anim::Ticks delta);
  /// The same as it was recorded: seen by that camera, in a picture of that size.
  void animate_as(const RecordedFrame& frame);

  /// Writes whatever is asked of the show from now on, and the poses that come of it, to `file`. A crowd that has moved
  /// begins anew, so that a replay can begin where this does; moments are kept. Errors: the file cannot be written.
  anim::Status start_recording(const std::filesystem::path& file);
  /// Errors: the file could not be written; nothing if none is.
  anim::Status stop_recording();
  bool is_recording() const { return recorder_ != nullptr; }
  /// Draws the frame as animated last, into the renderer's picture, and waits for it, so that the time is the whole
  /// frame's.
  void draw();
  bool draws() const { return renderer_ != nullptr; }

  render::Renderer& renderer() { return *renderer_; }
  render::gl::Context& context() { return *context_; }
  const Stage& stage() const { return *stage_; }
  const Picture& picture() const { return picture_; }
  /// Of the frame drawn last.
  const ThresholdsInView& thresholds() const { return thresholds_; }
  /// What laying out the overlay took in this frame.
  void add_overlay_time(double milliseconds) { statistics_.add_overlay(milliseconds); }
  const Statistics& statistics() const { return statistics_; }
  /// What `--trace` writes; nothing unless it was asked for.
  const std::optional<TimelineLog>& timeline() const { return timeline_; }
  DrawnBy drawn_by() const;
  const render::DrawCounts& draw_counts() const { return draw_counts_; }
  double last_update_ms() const { return update_ms_; }
  double last_draw_ms() const { return draw_ms_; }
  /// Of the last frame.
  const FrameTimes& frame_times() const { return times_; }
  bool on_software() const { return context_ != nullptr && context_->is_software(); }

  render::Camera camera;
  bool films = false;  ///< a camera path or the camera of a cut scene sets `camera` in each frame, where there is one
  int width = 0;
  int height = 0;
  /// Lines for people, of what is otherwise than they would expect (app/figures/notices.h); may be empty.
  std::string notice;

 private:
  Show() = default;
  bool open_context(const DemoOptions& options, StartError& error);
  bool open_renderer(const DemoOptions& options, StartError& error);
  bool open_stage(std::vector<CharacterSource> characters, const DemoOptions& options, StartError& error);
  anim::Status load_meshes(const Stage& stage);
  bool place_camera(const DemoOptions& options, StartError& error);
  void update_notice();
  void film();
  render::CrowdFrame crowd_frame(const Picture& picture) const;
  bool splits() const;
  void compose_exact();
  render::DrawCounts draw_pictures();
  void update(anim::Ticks delta, const LodView* as_recorded);  // null: as the show is seen now
  void freeze_lod_camera();
  void gather_lines();
  std::uint64_t completed_frame();
  int pick_mesh_lod(std::uint8_t character, float pixels_tall, int at_least) const;

  std::unique_ptr<render::gl::Context> context_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::HeapPageSource> heap_pages_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<RecordingWriter> recorder_;  // null while nothing is recorded
  Picture picture_;
  Picture exact_picture_;  // of a split view
  SceneLines lines_;
  Rewind rewind_;
  bool keeps_moments_ = false;
  std::optional<render::Camera> frozen_camera_;
  Statistics statistics_;
  std::optional<TimelineLog> timeline_;
  ThresholdsInView thresholds_;
  Spared spared_;
  render::DrawCounts draw_counts_;
  float mesh_detail_ = 1.0F;
  CameraPath path_ = CameraPath::none;
  render::Camera path_start_;
  FrameTimes times_;
  double update_ms_ = 0;
  double draw_ms_ = 0;
};

}  // namespace throng::app
