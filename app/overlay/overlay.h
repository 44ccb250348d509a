#pragma once

#include <filesystem>
#include <memory>

#include "app/overlay/ui_map.h"
#include "app/report/frame_report.h"
#include "app/settings/settings.h"
#include "app/view/input.h"

struct ImDrawData;

namespace throng::app {

/// The panel over the crowd: it reads a const report of the frame, edits a copy of the tuning, and returns commands.
///
///   +--------------------------------+-----------+
///   | notices                        | tabs      |   The crowd keeps what is left of a column of 380 pixels and
///   |            crowd               | Crowd,    |   above a strip of 132 (times the scale): 900 x 588 of
///   |                                | LOD, ...  |   1280 x 720.
///   +--------------------------------+           |
///   | frame graph                    |           |
///   +--------------------------------+-----------+
///
/// In the demo's loop, one window, one thread:
///
///   WindowInput window_input(context->window());
///   Overlay overlay(data / "fonts", ui_scale, tuning_defaults, window_input.clipboard());
///   overlay_renderer.upload_fonts();                      // engine/render/passes/overlay_renderer.h
///   while (!quit) {
///     const InputFrame& input = window_input.next_frame();
///     overlay.begin_frame(width, height, seconds, input);
///     OverlayCommands commands = overlay.build(report, tuning);      // report of the frame before; also the hotkeys
///     fly_camera.update(input, {!overlay.uses_pointer(), !overlay.uses_keyboard()}, seconds);
///     ... animate, draw the crowd ...
///     overlay_renderer.draw(*overlay.draw_data());
///     if (ui_map_wanted) write(to_json(overlay.ui_map(), tuning, report));
///   }
///
/// Owns the ImGui context and makes it current; one at a time.
class Overlay {
 public:
  /// `fonts`: the folder of the Roboto files; `scale` multiplies every measure; `standard` are the values that a reset
  /// goes back to.
  Overlay(const std::filesystem::path& fonts, float scale, const Tuning& standard, const Clipboard& clipboard = {});
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// `width`, `height`: pixels of the picture, above 0; `seconds` since the frame before.
  void begin_frame(int width, int height, double seconds, const InputFrame& input);

  /// Lays the overlay out and ends the frame; once after each begin_frame.
  OverlayCommands build(const FrameReport& report, Tuning& tuning);

  /// What to draw after build; valid until the next begin_frame.
  ImDrawData* draw_data() const;

  /// How much the last build drew; 0 when hidden.
  int vertex_count() const;

  /// Where everything lay in the last build.
  const UiMap& ui_map() const;

  /// The part of the picture that nothing covers.
  UiRectangle crowd_area() const;

  /// The pointer (keyboard) belongs to the overlay, not to the camera.
  bool uses_pointer() const;
  bool uses_keyboard() const;

  void set_hidden(bool hidden);
  /// Shows one of "Crowd", "LOD skipping", "Per-bone LOD", "Scheduling", "Agent", "Presets"; any other name is ignored.
  void show_tab(const std::string& name);

  /// The fonts were not found; ImGui's own is in use.
  bool fonts_missing() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace throng::app
