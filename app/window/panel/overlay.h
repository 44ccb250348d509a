#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "app/settings/settings.h"
#include "app/settings/tuning_pair.h"
#include "app/show/camera/input.h"
#include "app/show/report/frame_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/ui_map.h"

struct ImDrawData;

namespace throng::app {

/// Returns the folder of the fonts that an overlay reads; empty where there is none. `data` is what --data says.
std::filesystem::path fonts_folder(const std::string& data);

/// Returns the share of a picture's width that the panel's column takes at its right.
float column_share(int width, float scale);

/// The panel over the crowd. It reads a report of the frame and the tuning, and returns requests.
///
///   +--------------------------------+-----------+
///   | notices                        | tabs      |   The column is 380 pixels wide and the strip 132 high (times
///   |            crowd               | Crowd,    |   the scale); the crowd keeps the rest, 900 x 588 of
///   |                                | LOD, ...  |   1280 x 720. In a narrow window the column takes a third; a
///   |                                |           |   person drags its edge.
///   +--------------------------------+           |
///   | frame graph                    |           |
///   +--------------------------------+-----------+
///
/// The window's thread calls begin_frame and build in each frame, and then draws draw_data(). build also does what the
/// hotkeys ask for. app/window/window_loop.cpp is the loop.
///
/// It owns an ImGui context and makes it current until it ends, so the newest overlay is the only one in use.
class Overlay {
 public:
  /// `fonts` is the folder of the Roboto files. `scale` multiplies every measure. A reset goes back to `standard`.
  Overlay(const std::filesystem::path& fonts, float scale, const Tuning& standard, const Clipboard& clipboard = {});
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// Takes another scale before a frame, beside the one that the person chose by keys. Returns whether letters were
  /// made anew, which a renderer has to be prepared for.
  bool set_scale(float scale);

  /// Begins a frame, `seconds` after the one before. `width` and `height` are pixels of the picture, above 0.
  void begin_frame(int width, int height, double seconds, const InputFrame& input);

  /// Lays the overlay out and ends the frame. Returns the person's requests, in order; if values differ from
  /// `tuning`, they come last. Call it once after each begin_frame.
  Requests build(const FrameReport& report, const Tuning& tuning);

  /// Lays out, in place of build(), how far the start of a program is. Returns whether the person gives it up.
  bool build_start(const JobReport& job);

  /// Returns the triangles of the last build, which are valid until the next begin_frame.
  ImDrawData* draw_data() const;

  /// Returns the number of vertices of the last build; 0 when nothing is shown.
  int vertex_count() const;

  /// Returns the places of all widgets in the last build.
  const UiMap& ui_map() const;

  /// Returns the part of the picture that nothing covers.
  UiRectangle crowd_area() const;

  /// Returns that part without the timeline of a recorded crowd, which lies over its foot.
  UiRectangle free_area(const FrameReport& report) const;

  /// Returns the width that a person dragged the column to, in pixels of a plain screen; 0: it has its usual one.
  int panel_width() const;
  void set_panel_width(int width);

  /// Returns whether the pointer belongs to the overlay, not to the camera.
  bool uses_pointer() const;
  /// Returns whether the keyboard belongs to the overlay, not to the camera.
  bool uses_keyboard() const;

  /// Draws no ground for column and strip from now on: the caller fills what is outside of crowd_area() with
  /// panel_color(), opaque. To a processor that draws, blending over half a picture is much.
  void leave_ground_out();
  /// Returns the sRGB colour of the panels, red in the lowest byte.
  static std::uint32_t panel_color();

  /// Returns whether the person is in the middle of a change, such as a drag, whose requests belong together.
  bool is_in_a_change() const;

  /// Hides the panel. Ids above heads stay.
  void set_hidden(bool hidden);
  /// Hides the panel, and shows the legend from now on, with the time and the number of people.
  void show_legend_only();
  /// Shows one of "Crowd", "LOD skipping", "Per-bone LOD", "Scheduling", "Agent", "Presets"; any other name is ignored.
  void show_tab(const std::string& name);

  /// Returns the two tunings that the person compares, for the caller to keep or to exchange.
  TuningPair& tuning_pair();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace throng::app
