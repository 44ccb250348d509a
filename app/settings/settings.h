#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "throng/render/scene_light.h"
#include "throng/view_rules.h"

#include "app/character/cast_entry.h"
#include "app/character/load_options.h"
#include "app/character/roles.h"
#include "engine/anim/agent/system_options.h"
#include "engine/anim/import/import.h"
#include "engine/anim/lod/lod.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/tracks/reading.h"

namespace throng::app {

struct CrowdSetup;

enum class Scene : std::uint8_t { plaza, parade, stadium, grid, film, tracks };
enum class ContextKind : std::uint8_t { window, headless_default, egl, osmesa, none };
enum class DrawWhich : std::uint8_t { last, all, none };
enum class DebugView : std::uint8_t { none, interval, bone_level, mesh_lod, error, speed, density, presence };
/// Divides the picture at a line. Left of it is the exact crowd; right of it the crowd as shown, or the difference of
/// the two.
enum class Split : std::uint8_t { off, shown, difference };
/// The colours that people wear: their own, or the colours of a shape that is seen from above.
enum class Clothes : std::uint8_t { own, pattern };
enum class Weather : std::uint8_t { mild, warm, cold, rain };
/// The way that the camera moves by itself from its first place.
enum class CameraPath : std::uint8_t { none, orbit, pan };

/// The place of the camera: x, y, z in metres; yaw, pitch, vertical field of view in degrees. Yaw 0 looks along -Z.
struct CameraPose {
  float x = 0, y = 0, z = 0;
  float yaw = 0, pitch = 0;
  float field_of_view = 50;

  friend bool operator==(const CameraPose&, const CameraPose&) = default;
};

/// Leaves out parts of a frame, to show the cost of each.
struct TakenAway {
  bool animation = false;  ///< time stands still
  bool upload = false;     ///< the records of the last frame are drawn again; characters may jump
  bool drawing = false;    ///< no draw call: the picture stays
  bool pixels = false;     ///< the crowd is drawn, but no pixel of it is filled

  friend bool operator==(const TakenAway&, const TakenAway&) = default;
};

/// Ways to look at level of detail, and to try others. Presets keep the forced values only.
struct LodInspection {
  bool freeze_camera = false;  ///< level of detail and culling go on from where the camera was; its frustum is drawn
  bool thresholds = false;     ///< a ring on the ground wherever the interval grows
  bool figures_above_heads = false;  ///< interval and bone level of agents near by
  Split split = Split::off;
  float split_at = 0.35F;            ///< share of the picture's width, 0 to 1; left of it the crowd is exact
  int forced_interval = 0;           ///< frames, 1 to 16; 0: the rule decides
  int forced_bone_level = -1;        ///< 0 to 3, or the character's last; -1: the rule decides
  bool force_selected_only = false;  ///< the forced values are for the selected agent, else for all

  friend bool operator==(const LodInspection&, const LodInspection&) = default;
};

/// Returns the ways to look of one, with the values of the other that presets keep.
inline LodInspection with_kept_values(LodInspection looks, const LodInspection& kept) {
  looks.forced_interval = kept.forced_interval;
  looks.forced_bone_level = kept.forced_bone_level;
  looks.force_selected_only = kept.force_selected_only;
  return looks;
}

/// Every value that can be tuned while the crowd runs. The overlay edits a copy, and the demo applies it at a frame
/// boundary.
struct Tuning {
  // Crowd
  Scene scene = Scene::plaza;
  int agents = 1000;  ///< 1 to 100,000
  std::uint32_t seed = 1;
  bool variety = true;        ///< agents of one character differ in size and colours, as the next two say
  float tint = 1.0F;          ///< how much they differ in colours, 0 to 1
  float size_variety = 0.1F;  ///< how much they differ in size, as a share, 0 to 0.3
  Clothes clothes = Clothes::own;
  bool wardrobe = true;             ///< people are dressed out of the wardrobe of their character, where it has one
  Weather weather = Weather::mild;  ///< the weather that people dress for
  bool paused = false;
  float time_scale = 1.0F;  ///< 0 to 4
  bool placed_feet = true;  ///< feet near by stand where they came down; with LOD off all feet
  // Level of detail
  LodRules lod{.smooth = true};                      ///< lod_rules() puts the limits in
  ErrorSampling error_sample = ErrorSampling::some;  ///< the agents in view whose error on screen is measured
  float error_px = 1.0F;                             ///< LodRule::budget: p99 of the error on screen; 0: no such limit
  float budget_ms = 0.0F;  ///< LodRule::budget: predicted time of all PUs for a frame; 0: no such limit
  LodInspection inspection = {};
  int mesh_lod = -1;           ///< -1: by error on screen; 0 or more: always that mesh LOD
  float mesh_error_px = 0.5F;  ///< pixels that a coarser mesh is off at most; half of error_px at most
  int triangle_budget = 0;     ///< of all agents in view; coarser meshes keep to it; 0: no such limit
  // Scheduling
  anim::SystemOptions system{.pus = 0};  ///< pus 0: all cores, see on_this_machine
  // Light
  render::SceneLight light = {};
  bool shadows = true;      ///< everything casts shadows on everything
  bool crowd_shade = true;  ///< bodies keep the light of the sky from each other and from the ground
  // What is shown
  DebugView debug_view = DebugView::none;
  float top_speed = 2.0F;        ///< metres a second that the last colour stands for
  float top_density = 5.0F;      ///< people a square metre of the last colour
  float top_presence = 60.0F;    ///< seconds since a person appeared, of the last colour
  float density_cut_off = 1.0F;  ///< metres that a person's own ground reaches at most
  float trail_seconds = 0.0F;    ///< a recorded crowd's ways of so many seconds are drawn; 0: none
  bool plain_bodies = false;     ///< bodies without a colour of the debug view are grey
  bool ids = false;              ///< above heads stand the ids of a file, or the numbers of agents
  bool bones_as_lines = false;
  bool scenery = true;        ///< what stands around the crowd
  int picture_size = 100;     ///< per cent of a window's width and height in which the scene is drawn, 25 to 100
  bool holds_rate = false;    ///< a window gives up size, triangles and shadows to show `frame_rate` frames a second
  float frame_rate = 30.0F;   ///< frames a second, 5 to 240
  int frame_limit = 0;        ///< frames a second that a window shows at most; 0: no limit
  bool vertical_sync = true;  ///< a window shows a frame when the display is refreshed
  TakenAway taken_away{};

  friend bool operator==(const Tuning&, const Tuning&) = default;
};

/// The size of each local store in the unit of options and overlay; 0: automatic.
inline constexpr std::size_t bytes_a_kib = 1024;
inline int local_store_kib(const Tuning& tuning) {
  return static_cast<int>(tuning.system.local_store_bytes / bytes_a_kib);
}
inline void set_local_store_kib(Tuning& tuning, int kib) {
  tuning.system.local_store_bytes = static_cast<std::size_t>(kib) * bytes_a_kib;
}

/// Returns the tuning with which `--lod off` shows the same crowd: every agent is posed in full in every frame.
inline Tuning without_level_of_detail(Tuning tuning) {
  tuning.lod.rule = LodRule::off;
  tuning.lod.bone_lod = false;
  tuning.lod.smooth = false;
  tuning.mesh_lod = 0;
  tuning.inspection.forced_interval = LodInspection().forced_interval;
  tuning.inspection.forced_bone_level = LodInspection().forced_bone_level;
  return tuning;
}

/// The seconds of a headless frame without --dt.
inline constexpr double usual_frame_seconds = 1.0 / 60.0;
/// The range of --dt in seconds, and the largest factor that a window's clock multiplies it by.
inline constexpr double least_frame_seconds = 1e-6, most_frame_seconds = 3600;
inline constexpr float most_time_scale = 4;

/// The camera stands no farther from the origin on any axis, in metres.
inline constexpr float farthest_camera = 1e6F;

/// The largest width and height of a picture; PNG files of four times as many pixels are read by few programs.
inline constexpr int most_picture_pixels = 32767;
inline constexpr int most_window_pixels = 16384;    ///< of a window, which is one target
inline constexpr int most_labelled_agents = 65534;  ///< an id mask has 16 bits; 0 is no person

/// The recorded or simulated crowd that a run shows.
struct TrajectoryOptions {
  std::string file;  ///< empty: there is none
  TrackReading reading = {};
  std::optional<double> start = {};  ///< seconds of the file's clock; unset: where its part begins as it is played
  std::optional<double> rate = {};   ///< seconds of the file's clock a second, not 0; below 0: backwards
  std::optional<std::pair<double, double>> part = {};  ///< seconds of the file's clock, in any order; unset: all of it
  std::optional<bool> repeats = {};                    ///< the part begins anew at its end; unset: in a window alone

  friend bool operator==(const TrajectoryOptions&, const TrajectoryOptions&) = default;
};

/// Says what a headless run writes of each of its frames (app/output/README.md).
struct OutputOptions {
  std::string video;                        ///< FILE.mp4 or FILE.webm; empty: none
  std::string pictures, labels;             ///< folders; empty: none
  std::optional<double> frames_per_second;  ///< of the video; unset: it plays as fast as the run's time goes
  std::optional<double> seconds;            ///< the run's time; unset: DemoOptions::frames says its length
  std::vector<std::string> run;             ///< the words of the command line that decide the pictures

  bool any() const { return !video.empty() || !pictures.empty() || !labels.empty(); }
};

/// The values that a person asks for. The device decides over others (app/show/figures/notices.h, DeviceChoices).
struct GivenValues {
  std::vector<std::string> keys;  ///< of tuning_values(), each one said by itself
  bool all = false;               ///< a preset, a crowd file or a recording says all of them

  bool has(std::string_view key) const { return all || std::ranges::find(keys, key) != keys.end(); }
};

/// The options of the demo (app/commands/command_line/README.md). It starts with `tuning`.
struct DemoOptions {
  std::string crowd_file;                   ///< NAME.throng, which `crowd` was read from; empty: none was named
  std::shared_ptr<const CrowdSetup> crowd;  ///< what a crowd file or --crowd says; null: there is none
  std::vector<std::string> models;          ///< files and folders, even shares; empty: `cast`
  std::vector<CastEntry> cast;              ///< files and folders with shares; empty: the built-in character
  std::string cast_rules;                   ///< the file of rules for clothes; empty: as beside the models
  std::vector<std::string> clips_from;      ///< files whose clips every character plays too
  anim::PlacementChoice placement;          ///< size and place of all models; what it leaves open is guessed
  std::vector<ModelPlacement> placements;   ///< of single models, over the one of all
  TrajectoryOptions trajectories;
  Tuning tuning;
  ContextKind context = ContextKind::window;
  std::optional<DrawWhich> draw;           ///< unset: see drawn_frames; a window draws all
  const anim::Kernels* kernels = nullptr;  ///< of one SIMD target; null: the best
  int frames = 60;
  bool frames_given = false;  ///< a window runs until closed unless given
  std::optional<double> dt;   ///< seconds; unset: 1/60 headless, the clock in a window
  int width = 1280;
  int height = 720;
  int longest_tile = 4096;          ///< pixels; larger pictures are drawn in tiles of at most these sides
  bool ui = false;                  ///< overlay in a headless run
  bool legend = false;              ///< only the legend and the time, in a headless run
  bool ui_fixed = false;            ///< the overlay shows measured times from a committed report
  std::string ui_tab = "Crowd";     ///< the overlay starts with it
  std::optional<int> selected;      ///< an agent, from the start
  std::optional<std::string> view;  ///< the first character is shown alone, in this clip; empty: in any
  bool hide_ui = false;
  bool no_settings = false;        ///< a window does not start as the last one was left (user_settings.h)
  float ui_scale = 1;              ///< multiplies every measure of the overlay
  int msaa = -1;                   ///< 0 or 4; -1: as much as the device affords
  std::string skin;                ///< a character of each model that has several, "all" of them; empty: the largest
  import::ImportOptions reading;   ///< of models: whether models in need of repair are refused, and sizes
  std::vector<RoleChoice> clips;   ///< these go before the role file and the clips that names suggest
  GivenValues values_given;        ///< values of `tuning`
  std::optional<float> focus;      ///< metres ahead of the camera that are sharp in a still; unset: all is sharp
  float aperture = 1.4F;           ///< the f-number of its lens, on film 24 mm high
  std::vector<std::string> given;  ///< the options that the command line names, "--pus"
  bool force_software = false;     ///< EGL: never the graphics card; for tests
  std::optional<CameraPose> camera;
  CameraPath camera_path = CameraPath::none;
  std::string camera_path_file;                        ///< a path of keys in place of camera_path; empty: there is none
  std::string camera_name;                             ///< named camera of the scene, empty: the scene's first
  bool events = false;                                 ///< the statistics sum up the events of all agents
  std::string record, replay;                          ///< files; empty: not asked for
  std::string preset;                                  ///< the file of the preset that was read; empty: none
  OutputOptions output;                                ///< video, pictures and labels of all frames
  std::optional<double> unseen_seconds;                ///< that the crowd goes on before a headless run's first frame
  bool says_progress = false;                          ///< on standard error, in lines for another program
  bool remove_parts = false;                           ///< remove remains of killed runs beside the files to write
  std::string screenshot, stats, trace, ui_map, data;  ///< empty: not asked for; stats may be `-`, standard output
};

/// Returns the frames that a headless run draws: the frames asked for; else all, if something of each is written; else
/// the last, if something of it is written; else none.
inline DrawWhich drawn_frames(const DemoOptions& options) {
  if (options.output.any()) return DrawWhich::all;
  const bool is_seen = !options.screenshot.empty() || !options.ui_map.empty();
  return options.draw.value_or(is_seen ? DrawWhich::last : DrawWhich::none);
}

}  // namespace throng::app
