#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/character/bone_lod.h"
#include "app/character/roles.h"
#include "app/lod/lod_thresholds.h"
#include "app/report/selection_report.h"
#include "app/report/tuning_sweep.h"
#include "app/settings/settings.h"
#include "engine/anim/run/program/task_content.h"

namespace throng::app {

/// One span of work of one PU within the last frame, for the overlay's timeline.
struct PuSpan {
  enum class Kind : std::uint8_t { fetch, compute, write_back, wait };
  Kind kind = Kind::compute;
  float begin_ms = 0;  ///< from the start of the frame's update
  float end_ms = 0;
  std::uint64_t bytes_in = 0, bytes_out = 0, transfers = 0;  ///< copied meanwhile
  anim::TaskContent content = {};                            ///< for whom
};

/// What every PU did in one of the last frames.
struct TimelineFrame {
  int frame = 0;
  float length_ms = 0;
  std::vector<std::vector<PuSpan>> lanes;  ///< [PU]
};

/// What one PU did and moved in the last frame.
struct PuReport {
  std::uint32_t tiles = 0;
  std::uint32_t agents = 0;
  float busy_ms = 0;
  float wait_ms = 0;
  std::uint64_t dma_in_bytes = 0;
  std::uint64_t dma_out_bytes = 0;
  std::uint64_t dma_transfers = 0;
  std::uint32_t local_store_laid_out_bytes = 0;  ///< by plan: fetch buffers and scratch
  std::vector<PuSpan> spans;                     ///< may be empty
};

struct BoneRow {
  std::string name;
  int depth = 0;                   ///< in the hierarchy
  int level = 0;                   ///< the last level that still has it: 0 full only, 3 always
  int parent = -1;                 ///< place of its parent in the list
  float error_millimetres = 0.0F;  ///< on the surface without it, 99th percentile (anim::BoneLodRow)
  float nanoseconds = 0.0F;        ///< of an agent's update, by the cost model
};

/// Main memory of the blocks of one kind of entity, of all agents.
struct KindRow {
  std::string kind;
  std::uint64_t blocks = 0;
  std::uint64_t bytes = 0;           ///< of living blocks
  std::uint64_t reserved_bytes = 0;  ///< of the slabs they lie in
};

/// What level of detail gives an agent, to be written above its head.
struct HeadFigures {
  float x = 0, y = 0, z = 0;  ///< metres, just above it
  int interval = 1;
  int bone_level = 0;
};

/// A const view of all that the overlay shows; filled by the demo once a frame.
struct FrameReport {
  std::vector<std::string> characters;  ///< names shown: the files', or "mannequin (built in)"
  std::size_t character = 0;            ///< of these: whose roles and bones are below
  std::string context;                  ///< "window", "egl", "osmesa"
  std::string gl_version, gl_renderer;
  bool software_renderer = false;
  std::string notice;  ///< lines worth showing, such as what a software renderer turns down; may be empty
  int frame = 0;
  float frame_ms = 0, update_ms = 0, draw_ms = 0;
  std::vector<float> frame_ms_history, update_ms_history;  ///< oldest first, up to 240
  // crowd
  int agents = 0, visible = 0, drawn = 0;
  int agents_updated = 0;
  std::uint64_t bones_evaluated = 0;
  std::uint64_t pose_hash = 0;
  std::uint32_t draw_calls = 0;
  std::uint64_t triangles = 0;
  // roles
  std::vector<std::string> clip_names;          ///< of the character
  RoleClips role_clips = no_clips();            ///< in use
  RoleClips suggested_role_clips = no_clips();  ///< as the names suggest
  // LOD
  std::vector<int> agents_by_interval;                         ///< [i]: visible agents with interval i + 1
  std::vector<int> agents_by_bone_level;                       ///< up to 4
  std::vector<int> level_bone_counts;                          ///< up to 4
  float error_px_p50 = 0, error_px_p99 = 0, error_px_max = 0;  ///< of what is shown, over the last 60 frames
  float pop_px_max = 0;                                        ///< the largest change of an error between two frames
  int error_samples = 0;                                       ///< agents measured in these frames
  bool error_px_p99_is_known = false;                          ///< enough of them
  std::vector<BoneRow> bones;                                  ///< in level-of-detail order
  float lod_tolerance_px = 0;                                  ///< in force; 0 under rules that have none
  std::string binding_limit;                   ///< "none", "error", "budget" or "both miss"; empty under such rules
  float predicted_pose_ms = 0;                 ///< of all PUs, by the cost model, those who reappear included
  bool budget_held = true;                     ///< of this frame, those who reappear exempt
  float cost_culling_percent = 0;              ///< of the cost of everyone: saved since it is out of view
  float cost_skipping_percent = 0;             ///< of the cost of those in view: saved by skipping updates
  float cost_bones_percent = 0;                ///< of the same: saved by dropping bones
  std::vector<IntervalThreshold> thresholds;   ///< where the interval changes, the nearest first
  std::string threshold_clip;                  ///< of whom; empty: of all alike
  std::string limit_sentence;                  ///< who limits the frame rate, with figures
  std::vector<float> level_error_millimetres;  ///< [level]: of its surface, 99th percentile
  std::vector<HeadFigures> heads;              ///< of those near by, if asked for
  // scheduling
  int pus = 0, hardware_threads = 0;
  int local_store_kib = 0;
  int tile = 0;  ///< characters a tile, of the widest group
  std::string simd_target;
  std::uint32_t local_store_laid_out_bytes = 0;  ///< of each PU
  std::uint64_t dma_in_bytes = 0, dma_out_bytes = 0, dma_transfers = 0, palette_bytes = 0;
  std::vector<PuReport> pu;
  std::deque<TimelineFrame> timeline;  ///< the last frames, oldest first
  std::vector<KindRow> memory;         ///< kinds that have blocks
  SweepCurve sweep;                    ///< the newest; no stops: none was asked for yet
  CameraPlace camera;
  std::vector<std::string> preset_names;    ///< of presets that can be loaded, sorted
  int snapshots = 0;                        ///< of the crowd as it was, that it can be taken back to
  float snapshot_seconds = 0;               ///< how far back the newest of them is
  std::optional<SelectionReport> selected;  ///< the agent that was clicked at
};

/// A pixel from the top left of the picture.
struct PicturePoint {
  float x = 0, y = 0;
};

/// What the person asked for in the overlay this frame, besides the tuning it edits.
struct OverlayCommands {
  std::optional<std::size_t> character;  ///< whose roles and bones are to be shown
  std::optional<RoleClips> roles;        ///< other clips for the roles of the character shown
  bool save_roles = false;
  std::optional<BoneLodChoice> bone_lod;  ///< another order of the bones of the character shown
  bool save_bone_lod = false;             ///< beside the model
  bool export_lod = false;                ///< for another engine
  std::vector<std::string> models;        ///< files dropped on the window: characters for everyone
  bool step = false;                      ///< advance one frame while paused
  bool frame_crowd = false;               ///< as key F
  bool copy_camera = false;               ///< as key C
  bool screenshot = false;                ///< as key F12
  bool reload_shaders = false;            ///< key F5
  bool record = false;                    ///< begins or ends a recording, as key R
  bool quit = false;                      ///< key Esc, while nobody is selected
  std::optional<PicturePoint> select_at;  ///< clicked at, not at the overlay
  bool deselect = false;
  std::optional<float> hold_at;  ///< whoever is selected: its clip is held at these seconds
  bool let_go = false;           ///< whoever is held plays on
  bool rewind = false;           ///< the crowd goes back to the newest snapshot, next time to the one before it
  std::optional<std::string> save_preset, load_preset, delete_preset;  ///< by name
  bool copy_command_line = false;                                      ///< the tuning as options
  bool push_over = false;                                              ///< whoever is selected; as key P
  std::optional<SweptValue> sweep;                                     ///< begins anew, for this value
  bool stop_sweep = false;
  bool exact_crowd = false;  ///< while key X is held: nothing is skipped or simplified
};

}  // namespace throng::app
