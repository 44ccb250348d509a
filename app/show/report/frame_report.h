#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "throng/render/crowd_draw.h"

#include "app/character/body_parts.h"
#include "app/character/bone_lod.h"
#include "app/character/roles.h"
#include "app/people/crowd/people_over_time.h"
#include "app/people/wardrobe/cast_tuning.h"
#include "app/settings/idle_values.h"
#include "app/settings/output_choices.h"
#include "app/settings/settings.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/lod/lod_thresholds.h"
#include "app/show/report/frame_details.h"
#include "app/show/report/job_report.h"
#include "app/show/report/messages.h"
#include "app/show/report/replay_report.h"
#include "app/show/report/selection_report.h"
#include "app/show/report/tuning_sweep.h"
#include "app/show/report/viewer_report.h"
#include "engine/anim/entity/kind_memory.h"
#include "engine/anim/lod/error_window.h"
#include "engine/anim/lod/level_of_detail.h"
#include "engine/anim/run/schedule_options.h"
#include "engine/anim/survey/bone_lod.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/crowd/mesh_choice.h"
#include "engine/crowd/mesh_lods.h"
#include "engine/tracks/track_clock.h"

namespace throng::app {

/// One bone of the level-of-detail order.
struct BoneRow {
  std::string name;
  int depth = 0;    ///< depth in the hierarchy
  int parent = -1;  ///< its parent's place in the list
  anim::BoneLodRow lod;
};

/// What is to be written above the head of an agent.
struct HeadFigures {
  std::uint32_t agent = 0;
  float x = 0, y = 0, z = 0;  ///< metres, just above the head
  std::string id = {};        ///< empty: it is not asked for
  int interval = 0;           ///< frames; 0: level of detail is not asked for
  int bone_level = 0;
};

/// A character of the cast.
struct CastMember {
  double share = 1.0;
  double starting_share = 1.0;  ///< as it was loaded
  int agents = 0;
};

/// The size and place of the character shown.
struct PlacementReport {
  anim::PlacementChoice choice;  ///< the requested placement
  double scale = 1.0;            ///< applied: metres a unit of its file
  double guessed_scale = 1.0;    ///< applied where none is asked for
  double units_tall = 0.0;       ///< its height in units of its file, turned upright; 0 without extent
  std::string reasons;           ///< a sentence: the height and why
};

/// The rules by which the agents of the character shown dress.
struct WardrobeReport {
  CastTuning tuning;    ///< in force; without bodies where the character has no rules
  CastTuning standard;  ///< as the file says
  std::string file;     ///< where the rules come from; empty: no file
  int holding = 0;      ///< agents that hold something
};

/// Reports the error that level of detail shows on the screen.
struct ErrorReport {
  anim::ErrorFigures figures;      ///< over the last 60 frames, and further back where these have few samples
  anim::ErrorIntervals intervals;  ///< where the percentiles may lie by chance
  std::vector<float> p99_history, pop_history;  ///< pixels, oldest first, up to 240: a value for two frames
  std::string skipping_sentence;                ///< why skipping saves little at this frame rate; empty: it does pay
};

/// A mesh LOD of the character shown.
struct MeshLodRow {
  std::uint32_t triangles = 0;
  float error_mm = 0, face_error_mm = 0;
  float below_px = 0;  ///< height on screen below which it is drawn, where the error decides; infinity: always
  int agents = 0;      ///< in view, drawn with it
};

/// Reports the meshes with which the character shown is drawn, and the values that decide between them.
struct MeshReport {
  MeshTolerance tolerance;
  MeshFigures crowd;             ///< of all characters
  std::vector<MeshLodRow> lods;  ///< the full mesh first; empty where nothing is drawn
};

/// All that the overlay shows of the cameras.
struct CameraReport {
  bool can_film = false;                    ///< a film or a path can move the camera by itself
  bool films = false;                       ///< it does so now
  bool follows = false;                     ///< the camera goes where the selected agent goes
  float fly_speed = 6;                      ///< metres a second
  std::array<bool, bookmark_count> kept{};  ///< [bookmark]
};

/// The rates at which the timeline plays a recorded crowd; 1 is the rate of the file.
inline constexpr std::array<double, 7> track_rates = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

/// All that the timeline shows of a recorded crowd. What a person asks for is another clock.
struct TracksReport {
  TrackClock clock;
  std::shared_ptr<const PeopleOverTime> people;  ///< of the whole file; never null
};

/// The work that a person would lose by what was asked for.
struct UnsavedReport {
  std::vector<std::string> parts;  ///< a phrase each, such as "the values"
  std::string next;                ///< the file that is to be opened; empty: the window is to be closed
};

/// The recording that goes on.
struct RecordingReport {
  std::string file;     ///< empty: nothing is recorded
  double began_at = 0;  ///< on the clock of the messages
};

/// All that the overlay shows. The demo fills it once a frame, and the overlay only reads it.
struct FrameReport {
  std::vector<std::string> characters;  ///< names shown: the files', or "mannequin (built in)"
  std::uint32_t character = 0;          ///< index of the character whose roles and bones are below
  std::vector<CastMember> cast;         ///< [character]
  bool has_built_in_cast = false;       ///< the built-in character alone is all of the cast
  WardrobeReport wardrobe;              ///< of the character shown
  std::string context;                  ///< "window", "egl", "osmesa"
  std::string gl_version, gl_renderer;
  std::string notice;    ///< warnings that stay, a line each, such as what a software renderer turns down; may be empty
  std::string given_up;  ///< what a window gives up to hold its frame rate, in a line; may be empty
  std::string rate_advice;      ///< what a person can do about slow frames, in a line; may be empty
  Messages messages;            ///< the messages that the person was told
  std::vector<JobReport> jobs;  ///< that go on beside the crowd
  RecordingReport recording;
  OutputChoices output;  ///< for pictures and videos
  int frame = 0;
  float frame_ms = 0, update_ms = 0, draw_ms = 0;
  std::vector<float> frame_ms_history, update_ms_history;  ///< oldest first, up to 240
  // Crowd
  int agents = 0, visible = 0, drawn = 0;
  double seconds = 0;  ///< of the crowd's clock, or of a recorded crowd's file
  int people = 0;      ///< people who are there; of a recorded crowd some have not come yet, or have gone
  anim::UpdateReport work;
  std::uint64_t pose_hash = 0;
  render::DrawCounts draw_counts;
  // Roles
  std::vector<std::string> clip_names;          ///< the character's clips
  RoleClips role_clips = no_clips();            ///< the clips in use
  RoleClips suggested_role_clips = no_clips();  ///< the clips that the names suggest
  BodyParts body;                               ///< the parts of the character's body
  PlacementReport placement;                    ///< its size and place
  // Level of detail
  std::vector<int> agents_by_interval;    ///< [i]: visible agents with interval i + 1
  std::vector<int> agents_by_bone_level;  ///< [level]
  std::vector<int> level_bone_counts;     ///< [level]
  ErrorReport error;                      ///< of the shown poses
  std::vector<BoneRow> bones;             ///< in level-of-detail order
  bool can_undo_bones = false;            ///< the last change was made to their order
  anim::LodFigures lod;
  MeshReport meshes;                          ///< of the character shown
  std::vector<IntervalThreshold> thresholds;  ///< the distances where the interval changes, the nearest first
  std::string threshold_clip;                 ///< the clip that they hold for; empty: they hold for all
  std::string limit_sentence;                 ///< says what limits the frame rate, with figures
  std::vector<HeadFigures> heads;             ///< ids and figures of agents near by, if asked for
  // Scheduling
  int hardware_threads = 0;
  anim::ScheduleOptions schedule;
  std::string simd_target;
  std::vector<PuReport> pu;
  std::vector<TimelineFrame> timeline;   ///< the last frames, oldest first
  KeptFrames kept;                       ///< frames to look at after they have passed
  std::vector<anim::KindMemory> memory;  ///< the blocks of all agents
  SweepCurve sweep;                      ///< the newest sweep; no stops: none was asked for yet
  CameraPose camera;
  CameraReport cameras;
  std::optional<ReplayReport> replay;       ///< a recording is repeated
  std::optional<TracksReport> tracks;       ///< the scene is a recorded crowd
  Situation situation;                      ///< says which values have no effect
  std::vector<std::string> preset_names;    ///< names of presets that can be loaded, sorted
  std::vector<std::string> crowd_names;     ///< names of the crowd files in the working folder, sorted
  std::string crowd;                        ///< the crowd file of this work, as SaveCrowd names it; empty: it has none
  std::vector<std::string> recent_files;    ///< files that were opened or saved, the newest first
  std::optional<UnsavedReport> unsaved;     ///< the person is asked about it
  std::vector<float> snapshots;             ///< seconds back to each that the crowd can be taken to, newest first
  std::optional<SelectionReport> selected;  ///< the agent that was clicked at
  std::optional<ViewerReport> viewer;       ///< of the character that is shown alone, while the crowd waits
};

}  // namespace throng::app
