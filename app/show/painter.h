#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "throng/heap_pages.h"
#include "throng/render/context.h"
#include "throng/render/renderer.h"

#include "app/settings/settings.h"
#include "app/show/figures/notices.h"
#include "app/show/figures/run_figures.h"
#include "app/show/lod/lod_export.h"
#include "app/show/path_in_view.h"
#include "app/show/picture.h"
#include "app/show/scene_lines.h"
#include "app/show/scenery.h"
#include "app/show/show_view.h"
#include "app/show/thresholds_in_view.h"
#include "app/show/trails.h"
#include "engine/render/gl/device_timer.h"

namespace throng::app {

/// Draws a stage, with lines over it and the exact crowd beside it where a person asks for them. Without a context it
/// draws nothing, and palettes live on the heap.
class Painter {
 public:
  /// Makes a painter. Errors: there is no such context, or it cannot draw.
  static Result<std::unique_ptr<Painter>> create(const DemoOptions& options);

  bool draws() const { return renderer_ != nullptr; }
  bool is_on_software() const { return context_ != nullptr && context_->is_software(); }
  DrawnBy drawn_by() const;
  const DeviceChoices& device_choices() const { return device_choices_; }
  /// Says what is left out; empty where nothing is.
  std::string notice() const;
  /// Does what Scenery::lines_left_out does; known once a frame was drawn.
  std::size_t lines_left_out() const { return scenery_.lines_left_out(); }
  render::Renderer& renderer() { return *renderer_; }
  render::gl::Context& context() { return *context_; }

  /// Draws stills of that size from now on, as well as a headless run does (render::Renderer::set_still).
  Status set_still(glm::ivec2 size) { return renderer_->set_still(size, samples_of_still_); }

  render::PalettePageSource& palette_pages();
  /// Takes back every palette page when the stage that had the pages goes.
  void reset_palette_pages();
  /// Loads the meshes of the stage's characters, and tells the stage the errors of their LODs. Characters that were
  /// loaded before, and have not changed since, keep theirs. Things that the scene does not show have none.
  Status load_meshes(Stage& stage);
  /// Tells a stage whose crowd was dressed anew the errors of its mesh LODs.
  void follow_outfits(Stage& stage);
  /// Returns nothing where nothing is drawn.
  std::vector<MeshLevel> mesh_levels(std::size_t character) const;
  /// Returns the newest frame of the stage that nothing reads any more.
  std::uint64_t completed_frame(const Stage& stage);

  /// Draws the stage into the renderer's picture and waits for it, so that the time is the whole frame's. Errors: the
  /// device failed at it; the picture is not whole.
  Status draw(Stage& stage, const PaintedView& view, RunFigures& figures);
  /// Has the device time itself in each draw() from now on, where its clock is true; see FrameTimes::device_ms.
  void time_device();
  /// Draws a frame that is no stage's in the same way, in the light of a tuning; the run's figures do not count it.
  Status draw(render::CrowdFrame frame, const Tuning& tuning);
  /// Draws which agent is where in a stage, beside the picture that draw() made of it, or without one.
  Status draw_labels(Stage& stage, const PaintedView& view, bool is_drawn, render::LabelPicture& labels);
  /// Measures what each agent of picture() covers alone. Call it after draw_labels(); see Renderer::measure_bodies.
  Status measure_bodies(const Stage& stage, const PaintedView& view, std::span<const render::PixelBox> boxes,
                        std::span<render::BodyAlone> bodies);
  /// These functions describe the picture drawn last.
  const Picture& picture() const { return picture_; }
  const ThresholdsInView& thresholds() const { return thresholds_; }
  const render::DrawCounts& draw_counts() const { return draw_counts_; }

 private:
  Painter() = default;
  Status open_context(const DemoOptions& options);
  Status open_renderer(const DemoOptions& options);
  Status load_scenery(const std::string& data_option);
  render::CrowdFrame crowd_frame(const Stage& stage, const PaintedView& view, const Picture& picture);
  Status upload(Stage& stage, const PaintedView& view);
  render::DrawCounts draw_pictures(const Stage& stage, const PaintedView& view);
  void gather_lines(const Stage& stage, const PaintedView& view);

  std::unique_ptr<render::gl::Context> context_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<HeapPageSource> heap_pages_;
  std::optional<render::gl::DeviceTimer> device_timer_;  // goes before the context
  Picture picture_;
  Picture exact_picture_;  // the exact side of a split view
  SceneLines lines_;
  PathInView path_;
  Trails trails_;
  SceneLines trail_lines_;
  Scenery scenery_;
  ThresholdsInView thresholds_;
  DeviceChoices device_choices_;
  int samples_of_still_ = 4;
  std::vector<std::weak_ptr<const anim::Character>> loaded_;  // [mesh] the character that it shows
  std::uint64_t looks_number_ = 0;                            // number of the looks whose mesh LODs the stage knows
  float distance_scale_ = 1.0F;                               // of the characters whose meshes are loaded
  render::DrawCounts draw_counts_;
};

}  // namespace throng::app
