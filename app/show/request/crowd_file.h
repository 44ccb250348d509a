#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/settings/preset.h"
#include "app/settings/tuning_pair.h"
#include "app/show/camera/camera_bookmarks.h"
#include "app/show/request/chosen_character.h"
#include "engine/base/result.h"

namespace throng::app {

/// All that is open: the characters, the recorded crowd, the values, and the cameras. A crowd file holds it, and so
/// does the command line that a window copies (crowd_command.h).
struct CrowdSetup {
  std::vector<ChosenCharacter> characters;  ///< 1 to most_models; none in the text of --crowd: other options name them
  TrajectoryOptions trajectories = {};      ///< no file: there is no recorded crowd
  Preset preset;                            ///< its tuning is the one in use
  std::string camera_name = {};             ///< what else `--camera` takes than a place, follow:ID; empty: nothing
  std::string camera_path = {};             ///< as `--camera-path` takes it; empty: nothing moves the camera
  TuningPair pair = {};                     ///< the values that are compared with those in use
  CameraBookmarks bookmarks = {};
};

inline constexpr const char* crowd_file_ending = ".throng";
bool is_crowd_file(const std::filesystem::path& file);
/// Returns the NAMEs of all NAME.throng in a folder, sorted.
std::vector<std::string> crowd_names(const std::filesystem::path& folder);

CrowdSetup crowd_setup(std::span<const CharacterSource> people, const Preset& preset);

/// Returns one JSON object with "version", "characters", "values", which are a preset's, and where they are not empty
/// "trajectories", "camera_name", "camera_path", "compare" and "bookmarks".
Json to_json(const CrowdSetup& setup);

/// Makes the options of a run begin with a setup, whatever they were.
void begin_with(const CrowdSetup& setup, DemoOptions& options);
/// Reads the text of `--crowd`: an object of to_json() of which all can be left out. Names of files are as they stand.
ValueReader crowd_text(DemoOptions& options);

/// Writes the file NAME.throng whole or not at all: the object of to_json(). Names of files are relative to the folder
/// of NAME.throng, so that both can move together.
Status write_crowd_file(const std::filesystem::path& file, const CrowdSetup& setup);
/// Reads such a file. Values that it does not have keep their defaults. The error is one line that names the file, what
/// is wrong in it and what is allowed.
Result<CrowdSetup> read_crowd_file(const std::filesystem::path& file);

}  // namespace throng::app
