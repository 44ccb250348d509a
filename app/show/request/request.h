#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "app/character/bone_lod.h"
#include "app/character/rig_choice.h"
#include "app/character/roles.h"
#include "app/people/wardrobe/cast_tuning.h"
#include "app/settings/settings.h"
#include "app/show/report/job_report.h"
#include "app/show/report/swept_value.h"
#include "app/show/report/viewer_report.h"
#include "app/show/request/chosen_character.h"
#include "app/show/request/output_requests.h"
#include "engine/anim/survey/placement_guess.h"
#include "engine/tracks/track_clock.h"

/// All that a person, a file or a test can ask for, as values. The panel, keys and drops put requests into a list, and
/// a window takes them in order at a frame boundary (app/window/window_requests.h). Whatever changes the crowd goes
/// through Show::take(), from a window, a recording or a test.
namespace throng::app {

/// The number of a character among the people of a crowd.
using CharacterNumber = std::uint32_t;

// ---- Requests about the crowd. A recording keeps them, and a replay makes them again. `name` is what files call them;
// describe() hands each value to `fields(key, value)`, or with the range that it must be in.

/// Other values, all of them.
struct Apply {
  static constexpr const char* name = "values";
  Tuning tuning;
  static constexpr auto describe = [](auto& self, auto& fields) { fields("values", self.tuning); };
};

/// A character's share of the crowd.
struct SetShare {
  static constexpr const char* name = "share";
  CharacterNumber character = 0;
  double share = 1.0;  ///< is_share() holds
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields("share", self.share, 0.0, most_share);
  };
};

/// The clips that a character plays for all roles.
struct SetRoles {
  static constexpr const char* name = "roles";
  CharacterNumber character = 0;
  RoleClips clips = no_clips();
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields("clips", self.clips);
  };
};

/// All parts of a character's body that a person says, which replace the parts of before.
struct SetBody {
  static constexpr const char* name = "body";
  CharacterNumber character = 0;
  std::vector<RigChoice> parts;
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields("parts", self.parts);
  };
};

/// Another order of a character's bones, and other levels.
struct SetBones {
  static constexpr const char* name = "bones";
  CharacterNumber character = 0;
  BoneLodChoice choice;
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields("order", self.choice.bones);
    fields("level_counts", self.choice.level_counts);
  };
};

/// Another size and place of a character, which is loaded anew.
struct SetPlacement {
  static constexpr const char* name = "placement";
  CharacterNumber character = 0;
  anim::PlacementChoice choice;
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields("placement", self.choice);
  };
};

/// Other rules of which of a character's agents wear what.
struct SetRules {
  static constexpr const char* name = "rules";
  CharacterNumber character = 0;
  std::string rules;      ///< JSON of one line (wardrobe/cast_rules_text.h); empty: no agent dresses
  std::string file = {};  ///< where the rules come from now; empty: where they did
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("character", self.character);
    fields.rules("rules", self.rules);
    fields("file", self.file);
  };
};

/// Other characters for all agents, from files and folders that came together (load_dropped). A recording keeps the
/// characters that came of it, as SetCast.
struct LoadModels {
  static constexpr const char* name = "models";
  std::vector<std::string> files;
  static constexpr auto describe = [](auto& self, auto& fields) { fields("files", self.files); };
};

/// Other characters for all agents.
struct SetCast {
  static constexpr const char* name = "cast";
  std::vector<ChosenCharacter> characters;  ///< 1 to most_models
  static constexpr auto describe = [](auto& self, auto& fields) { fields("characters", self.characters); };
};

/// The agent that is looked at.
struct Select {
  static constexpr const char* name = "select";
  std::optional<std::uint32_t> agent;  ///< nothing: none
  static constexpr auto describe = [](auto& self, auto& fields) { fields("agent", self.agent); };
};

/// An agent is pushed over.
struct Push {
  static constexpr const char* name = "push";
  std::uint32_t agent = 0;
  glm::vec3 direction{0.0F};  ///< of the world
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("agent", self.agent);
    fields("direction", self.direction);
  };
};

/// An agent's clip is held.
struct Hold {
  static constexpr const char* name = "hold";
  static constexpr double longest_clip = 1e6;  ///< seconds
  std::optional<std::uint32_t> agent;          ///< nothing: the clip that was held is let go
  float seconds = 0;                           ///< from the clip's start
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("agent", self.agent);
    fields("seconds", self.seconds, -longest_clip, longest_clip);
  };
};

/// The crowd goes back to a moment that was kept; it and all newer ones are forgotten.
struct GoBack {
  static constexpr const char* name = "go_back";
  std::uint32_t moment = 0;  ///< 0: the newest
  static constexpr auto describe = [](auto& self, auto& fields) { fields("moment", self.moment); };
};

/// A recorded crowd goes to another time, or is played otherwise.
struct Seek {
  static constexpr const char* name = "seek";
  TrackClock clock;
  static constexpr auto describe = [](auto& self, auto& fields) {
    fields("seconds", self.clock.seconds);
    fields("first", self.clock.first);
    fields("last", self.clock.last);
    fields("rate", self.clock.rate);
    fields("repeats", self.clock.repeats);
  };
};

using CrowdRequest = std::variant<Apply, SetShare, SetRoles, SetBody, SetBones, SetPlacement, SetRules, LoadModels,
                                  SetCast, Select, Push, Hold, GoBack, Seek>;

// ---- Requests about the window: its files, cameras and views. No recording keeps them. What follows for the crowd of
// one of them is a request above.

/// A pixel from the top left of the window.
struct PicturePoint {
  float x = 0, y = 0;
};

/// Selects the agent that is seen there.
struct SelectAt {
  PicturePoint point;
};
/// Files that came together are opened by their kinds: models, a recorded crowd, a crowd file.
struct OpenFiles {
  std::vector<std::string> files;
};
/// Takes the last request about values or characters back, or makes it again.
struct Undo {};
struct Redo {};
/// Time stands still, and one frame passes.
struct StepFrame {};
/// In this frame nothing is skipped or simplified.
struct ShowExactCrowd {};
/// Tells the person something that cannot be done.
struct Tell {
  std::string words;
};
/// Closes the window. A person with unsaved work is asked first.
struct Quit {};
/// A person who is asked about unsaved work gives it up, or goes on with it.
struct LeaveUnsaved {};
struct KeepWorking {};
/// A job that goes on beside the crowd ends; what was there before stays.
struct CancelJob {
  SideJob job = SideJob::loading;
};
/// The window fills its screen, or goes back to its place.
struct ToggleFullScreen {};

// Files. A name is a preset's, or a file's without its ending, in the working folder if it names no other.
struct SavePreset {
  std::string preset;
};
struct LoadPreset {
  std::string preset;
};
struct DeletePreset {
  std::string preset;
};
/// The values of a preset wait beside the values in use, to be compared.
struct LoadIntoOther {
  std::string preset;
};
struct SaveCrowd {
  std::string crowd;
};
struct OpenCrowd {
  std::string crowd;
};
struct SaveRules {
  std::string rules;
};
struct LoadRules {
  std::string rules;  ///< empty: the file in force, once more
};
// These are kept beside the model of the character shown.
struct SaveRoles {};
struct SaveBody {};
struct SaveBones {};
/// Its level of detail, for another engine.
struct ExportLod {};
/// Begins or ends a recording.
struct ToggleRecording {};
struct CopyCamera {};
/// All that is open as a command line.
struct CopyCommandLine {};
struct ReloadShaders {};

// The panel.
/// Shows the roles, bones and rules of another character.
struct ShowCharacter {
  CharacterNumber character = 0;
};
/// The rules of the character shown get other values.
struct TuneRules {
  CharacterNumber character = 0;
  CastTuning tuning;
};
/// A value goes through its stops while the crowd runs, to be measured.
struct StartSweep {
  SweptValue value = SweptValue::tile;
};
struct StopSweep {};
/// The kept frame whose number is nearest is looked at.
struct LookAtFrame {
  int frame = 0;
};
struct LookAtLastFrames {};

// Cameras.
/// The scene's first camera; a film has it again.
struct GoHome {};
struct GoToCamera {
  std::size_t camera = 0;  ///< of scene_camera_names
};
/// Moves the camera until the whole crowd is seen.
struct FrameCrowd {};
/// Follows the selected agent, or no longer.
struct ToggleFollow {};
struct FollowBehind {};
struct SetFlySpeed {
  float speed = 0;  ///< metres a second
};
struct KeepBookmark {
  std::size_t place = 0;  ///< below bookmark_count
};
struct GoToBookmark {
  std::size_t place = 0;
};

// The viewer of one character.
/// Shows a character alone.
struct View {
  ViewRequest what;
};
/// Shows the selected agent's character alone.
struct ViewSelected {};
struct LeaveViewer {};
struct SetViewer {
  ViewerSettings settings;
};
/// Holds the clip at these seconds.
struct ScrubViewer {
  float seconds = 0;
};
/// The turntable goes back to where it began.
struct FaceFront {};
/// The crowd plays the clip that was looked at for its role, and is shown again.
struct ApplyPreview {};

// A replay.
struct ToggleReplayPause {};
struct ToggleReplayLoop {};
struct StepReplay {
  int frames = 0;  ///< on, or back where below 0; then it pauses
};
struct SeekReplay {
  std::uint64_t frame = 1;  ///< from 1
};
struct SetReplaySpeed {
  float speed = 1;
};

using WindowRequest =
    std::variant<SelectAt, OpenFiles, Undo, Redo, Tell, ToggleRecording, CopyCamera, CopyCommandLine, ReloadShaders,
                 ShowCharacter, TuneRules, StartSweep, StopSweep, LookAtFrame, LookAtLastFrames, FrameCrowd,
                 LeaveUnsaved, KeepWorking, CancelJob, MakeVideo, SetOutput>;
/// What the loop does with the frame in which it is asked for.
using FrameRequest = std::variant<StepFrame, ShowExactCrowd, TakeScreenshot, TakeStill, ToggleFullScreen, Quit>;
using FileRequest = std::variant<SavePreset, LoadPreset, DeletePreset, LoadIntoOther, SaveCrowd, OpenCrowd, SaveRules,
                                 LoadRules, SaveRoles, SaveBody, SaveBones, ExportLod>;
using CameraRequest =
    std::variant<GoHome, GoToCamera, ToggleFollow, FollowBehind, SetFlySpeed, KeepBookmark, GoToBookmark>;
using ViewerRequest = std::variant<View, ViewSelected, LeaveViewer, SetViewer, ScrubViewer, FaceFront, ApplyPreview>;
using ReplayRequest = std::variant<ToggleReplayPause, ToggleReplayLoop, StepReplay, SeekReplay, SetReplaySpeed>;

using Request =
    std::variant<CrowdRequest, WindowRequest, FrameRequest, FileRequest, CameraRequest, ViewerRequest, ReplayRequest>;

}  // namespace throng::app
